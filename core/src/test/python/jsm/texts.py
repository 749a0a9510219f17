"""Texts: bytes under the two before them, with the longest match of the history as a guess."""

from .entropy import Contexts, IntegerModel

# docs/format.md, Texts
BEFORE = "".join(
    (
    'KHR_texture_transform":{"rotation":"offset":[0,"scale":[1,"KHR_materials_unlit":{},"KHR_materials_em',
    'issive_strength":{"emissiveStrength":"KHR_materials_ior":{"ior":1.5},"KHR_materials_specular":{"spec',
    'ularColorFactor":[1.0,"KHR_materials_transmission":{"transmissionFactor":"KHR_materials_volume":{"at',
    'tenuationColor":"KHR_materials_clearcoat":{"clearcoatFactor":"clearcoatRoughnessFactor":"KHR_materia',
    'ls_sheen":{"pbrSpecularGlossiness":{"diffuseFactor":"extras":{"extensions":{"alphaCutoff":0.5,"alpha',
    'Mode":"MASK","alphaMode":"BLEND","alphaMode":"OPAQUE","emissiveFactor":[0.0,0.0,0.0],"texCoord":1},"',
    'name":"doubleSided":true,"emissiveTexture":{"index":{"source":3}},"occlusionTexture":{"strength":1,"',
    'index":{"source":2}},"normalTexture":{"scale":1,"index":{"source":1}},"metallicRoughnessTexture":{"i',
    'ndex":"sampler":{"magFilter":9729,"minFilter":9987,"wrapS":33071,"wrapT":33071},"wrapT":10497}.jpeg.',
    'jpg.webp.png material Material image texture map_Kd map_Ks map_Bump Ka Ks Ns Ni illum {"doubleSided"',
    ':true,"pbrMetallicRoughness":{"baseColorFactor":[1,1,1,1],"metallicFactor":0.0,"baseColorTexture":{"',
    'index":{"source":0}},"roughnessFactor":'
    )
).encode()


class TextModel:
    def __init__(self):
        self.lengths = IntegerModel()
        self.history = bytearray()
        self.table = {}
        self.match = -1
        self.run = 0
        self.guessed = Contexts()
        self.after_one = Contexts()
        self.after_two = Contexts()
        for byte in BEFORE:
            for contexts, bit in self._bits(byte):
                for context in contexts:
                    context.learn(bit)
            self._append(byte)

    def _contexts(self, n):
        one = self.history[-1] if self.history else 0
        two = self.history[-2] if len(self.history) > 1 else 0
        return (
            self.after_one[((256 * one + n) * 0x9E3779B1 & 0xFFFFFFFF) >> 18],
            self.after_two[((65536 * two + 256 * one + n) * 0x9E3779B1 & 0xFFFFFFFF) >> 18],
        )

    def _bits(self, byte):
        n = 1
        for shift in range(7, -1, -1):
            bit = byte >> shift & 1
            yield self._contexts(n), bit
            n = n << 1 | bit

    def _append(self, byte):
        history = self.history
        if self.match >= 0 and history[self.match] == byte:
            self.match += 1
            self.run += 1
        else:
            self.match = -1
        history.append(byte)
        if len(history) < 4:
            return
        key = (int.from_bytes(history[-4:], "big") * 0x9E3779B1 & 0xFFFFFFFF) >> 20
        if self.match < 0 and key in self.table:
            place = self.table[key]
            run = 0
            while run < min(31, place) and history[place - 1 - run] == history[-1 - run]:
                run += 1
            if run >= 4:
                self.match = place
                self.run = run
        self.table[key] = len(history)

    def text(self, decoder):
        length = self.lengths.unsigned(decoder)
        for _ in range(4):
            self._append(0)
        start = len(self.history)
        for _ in range(length):
            self._append(self._byte(decoder))
        return self.history[start:].decode()

    def _byte(self, decoder):
        if self.match >= 0 and decoder.bit(self.guessed[min(31, self.run)]):
            return self.history[self.match]
        n = 1
        while n < 256:
            n = n << 1 | decoder.bit2(*self._contexts(n))
        return n & 255
