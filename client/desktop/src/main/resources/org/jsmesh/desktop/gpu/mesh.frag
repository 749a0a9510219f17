#version 330 core
// A surface after the model of glTF 2.0 (appendix B): a matte part and a glossy one after Trowbridge and Reitz, under the
// light that Lighting describes. Terms and constants are those of three.js 0.181, so that page and window look alike.
in vec3 eyePosition;
in vec3 eyeNormal;
in vec4 eyeTangent;
in vec4 linearColour;

const int SLOTS = 8;
// As in org.jsmesh.display.Slot.
const int COLOUR = 0;
const int METALLIC = 1;
const int ROUGHNESS = 2;
const int NORMAL = 3;
const int BUMP = 4;
const int OCCLUSION = 5;
const int EMISSION = 6;
const int OPACITY = 7;

in vec2 places[SLOTS];
in float error;

// As in org.jsmesh.desktop.draw.Shading, and the edges of triangles.
const int FLAT = 1;
const int NORMALS = 2;
const int LEVELS = 3;
const int ERROR = 4;
const int EDGES = 5;

uniform int shading;
uniform vec4 edges;
// sRGB, as in org.jsmesh.desktop.draw.Palette, and the number at its bright end.
uniform vec3 palette[10];
uniform float most;
// Of each triangle, by its place.
uniform samplerBuffer levels;
uniform int firstPlace;

uniform mat4 view;
uniform sampler2D images[SLOTS];
uniform bool shown[SLOTS];
uniform int channels[SLOTS];
uniform float factors[SLOTS];
uniform vec4 surface;
uniform vec3 emission;
uniform float metallic;
uniform float roughness;
// Of a surface that is no metal: from straight ahead, and from the side.
uniform vec4 reflectance;
uniform vec2 coat;
uniform bool unlit;
uniform bool imageOpacity;
uniform bool blended;
uniform float cutoff;

uniform vec3 sky;
uniform vec3 ground;
uniform vec3 keyDirection;
uniform vec3 keyLight;
uniform float studioLight;
uniform sampler3D studio;
uniform float studioLevels;
uniform float studioSide;
uniform sampler2D reflectances;
uniform float exposure;

out vec4 colour;

const float PI = 3.14159265;
const float SMOOTHEST = .0525;

float one(vec4 texel, int channel) {
    return channel < 0 ? texel.r : texel[channel];
}

vec3 toLinear(vec3 s) {
    return mix(s / 12.92, pow((s + .055) / 1.055, vec3(2.4)), greaterThan(s, vec3(.04045)));
}

vec3 toScreen(vec3 l) {
    vec3 c = clamp(l, 0, 1);
    return mix(12.92 * c, 1.055 * pow(c, vec3(1 / 2.4)) - .055, greaterThan(c, vec3(.0031308)));
}

// Khronos PBR Neutral tone mapper: colours below .8 stay as they are, brighter ones approach white.
vec3 toned(vec3 light) {
    const float START = .8 - .04;
    vec3 c = exposure * light;
    float least = min(c.r, min(c.g, c.b));
    c -= least < .08 ? least - 6.25 * least * least : .04;
    float peak = max(c.r, max(c.g, c.b));
    if (peak < START) return c;
    float room = 1 - START;
    float lower = 1 - room * room / (peak + room - START);
    return mix(vec3(lower), c * lower / peak, 1 / (.15 * (peak - lower) + 1));
}

// How far a surface is blurred that is so rough: 0 is the sharpest level of the studio.
float blur(float rough) {
    if (rough < .21) return clamp(7 + 2 * log2(1.16 * rough), 0, 3);
    if (rough < .305) return 3 + (rough - .21) / .095;
    if (rough < .4) return 4 + (rough - .305) / .095;
    if (rough < .8) return 5 + (rough - .4) / .4 * 3;
    return 8 + (rough - .8) / .2;
}

// Light of the studio from a direction of eye space; the place on the map is that of SphereMap.
float fromStudio(vec3 direction, float rough) {
    vec3 d = transpose(mat3(view)) * direction;
    d /= abs(d.x) + abs(d.y) + abs(d.z);
    vec2 p = d.xz;
    if (d.y < 0) p = (1 - abs(p.yx)) * vec2(p.x < 0 ? -1 : 1, p.y < 0 ? -1 : 1);
    vec2 at = (1 + (p + 1) / 2 * (studioSide - 2)) / studioSide;
    return studioLight * textureLod(studio, vec3(at, (blur(rough) + .5) / studioLevels), 0).r;
}

float mirrored(vec3 n, vec3 toEye, float rough) {
    vec3 d = normalize(mix(reflect(-toEye, n), n, rough * rough * rough * rough));
    return fromStudio(d, rough);
}

// Light of the key lamp that a glossy surface sends to the eye, of what falls on it: Smith's shadowing with correlated
// heights (Heitz 2014), Schlick's Fresnel term.
vec3 gloss(vec3 n, vec3 toEye, vec3 f0, float f90, float rough) {
    vec3 halfway = normalize(keyDirection + toEye);
    float alpha = rough * rough;
    float square = alpha * alpha;
    float light = clamp(dot(n, keyDirection), 0, 1);
    float eye = clamp(dot(n, toEye), 0, 1);
    float tilt = clamp(dot(n, halfway), 0, 1);
    float spread = tilt * tilt * (square - 1) + 1;
    float hidden = light * sqrt(square + (1 - square) * eye * eye) + eye * sqrt(square + (1 - square) * light * light);
    vec3 fresnel = mix(f0, vec3(f90), pow(1 - clamp(dot(toEye, halfway), 0, 1), 5));
    return fresnel * square / (PI * spread * spread) * .5 / max(hidden, 1e-6);
}

vec2 reflected(float cosine, float rough) {
    return texture(reflectances, vec2(rough, clamp(cosine, 0, 1))).rg;
}

// The part of the key lamp's light that leaves the surface only after it was reflected twice (Turquin 2019).
vec3 glossAgain(vec3 n, vec3 toEye, vec3 f0, float f90, float rough) {
    vec2 eye = reflected(dot(n, toEye), rough);
    vec2 light = reflected(dot(n, keyDirection), rough);
    vec3 mean = f0 + (1 - f0) / 21;
    float lost = (1 - eye.x - eye.y) * (1 - light.x - light.y);
    return (f0 * eye.x + f90 * eye.y) * (f0 * light.x + f90 * light.y) * mean * lost / (1 - lost * mean * mean + 1e-6);
}

// The normal of the side that is seen. Near a silhouette, where a face may be seen from either side by a rounding error,
// it is bent towards the eye instead of turned: both sides get the same light there.
vec3 facing(vec3 n, vec3 toEye) {
    float away = -dot(n, toEye);
    if (gl_FrontFacing || away <= 0) return n;
    return normalize(mix(n + 2 * away * toEye, -n, smoothstep(0, .2, away)));
}

// The normal of the image, in a frame of the vertices' tangents or else of how the place on the image changes.
vec3 fromImage(vec3 n, vec3 plain, float side) {
    vec3 texel = texture(images[NORMAL], places[NORMAL]).xyz * 2 - 1;
    texel.xy *= factors[NORMAL];
    if (eyeTangent.w != 0) {
        vec3 bitangent = normalize(cross(eyeNormal, eyeTangent.xyz) * eyeTangent.w);
        return normalize(side * (normalize(eyeTangent.xyz) * texel.x + bitangent * texel.y) + plain * texel.z);
    }
    vec3 right = cross(dFdy(eyePosition), n);
    vec3 up = cross(n, dFdx(eyePosition));
    vec2 stepRight = dFdx(places[NORMAL]);
    vec2 stepUp = dFdy(places[NORMAL]);
    vec3 tangent = right * stepRight.x + up * stepUp.x;
    // The image's y points down.
    vec3 bitangent = -right * stepRight.y - up * stepUp.y;
    float longest = max(dot(tangent, tangent), dot(bitangent, bitangent));
    float scale = longest == 0 ? 0 : inversesqrt(longest);
    // Where the face is seen from behind, the derivatives run the other way round.
    if (!gl_FrontFacing) scale = -scale;
    return normalize((tangent * texel.x + bitangent * texel.y) * scale * side + plain * texel.z);
}

// Bumps of an unparametrized surface (Mikkelsen 2010); heights count per pixel of the screen.
vec3 bumped(vec3 n) {
    vec2 place = places[BUMP];
    float height = one(texture(images[BUMP], place), channels[BUMP]);
    vec2 slope = factors[BUMP]
            * vec2(one(texture(images[BUMP], place + dFdx(place)), channels[BUMP]) - height,
                    one(texture(images[BUMP], place + dFdy(place)), channels[BUMP]) - height);
    vec3 right = normalize(dFdx(eyePosition));
    vec3 up = normalize(dFdy(eyePosition));
    vec3 first = cross(up, n);
    vec3 second = cross(n, right);
    float area = dot(right, first) * (gl_FrontFacing ? 1 : -1);
    return normalize(abs(area) * n - sign(area) * (slope.x * first + slope.y * second));
}

vec3 lit(vec3 albedo, float metal, float rough, vec3 plain, vec3 n, vec3 toEye, float open) {
    vec3 change = max(abs(dFdx(plain)), abs(dFdy(plain)));
    float bend = max(change.x, max(change.y, change.z));
    float r = min(max(rough, SMOOTHEST) + bend, 1);
    vec3 f0 = mix(reflectance.rgb, albedo, metal);
    float f90 = mix(reflectance.a, 1, metal);
    vec3 matte = albedo * (1 - metal);

    vec3 key = keyLight * clamp(dot(n, keyDirection), 0, 1);
    vec3 light = key * (matte / PI + gloss(n, toEye, f0, f90, r) + glossAgain(n, toEye, f0, f90, r));

    float cosine = clamp(dot(n, toEye), 0, 1);
    vec2 share = reflected(cosine, r);
    vec3 once = f0 * share.x + f90 * share.y;
    float lost = 1 - share.x - share.y;
    vec3 mean = f0 + (1 - f0) / 21;
    vec3 again = once * mean / (1 - lost * mean) * lost;
    vec3 glossy = once + again;
    float around = fromStudio(n, 1);
    vec3 diffuse = matte * mix(ground, sky, .5 + .5 * dot(n, view[1].xyz)) / PI
            + matte * (1 - max(glossy.r, max(glossy.g, glossy.b))) * around;
    vec3 specular = mirrored(n, toEye, r) * once + around * again;
    float clear = clamp(pow(cosine + open, exp2(-16 * r - 1)) - 1 + open, 0, 1);
    light += open * diffuse + clear * specular;

    if (coat.x > 0) {
        float c = min(max(coat.y, SMOOTHEST) + bend, 1);
        vec2 thin = reflected(dot(plain, toEye), c);
        vec3 over = keyLight * clamp(dot(plain, keyDirection), 0, 1) * gloss(plain, toEye, vec3(.04), 1, c)
                + open * mirrored(plain, toEye, c) * (.04 * thin.x + thin.y);
        float f = mix(.04, 1, pow(1 - clamp(dot(plain, toEye), 0, 1), 5));
        light = light * (1 - coat.x * f) + coat.x * over;
    }
    return light;
}

// The normal of the triangle on the side that is seen.
vec3 ofTriangle() {
    return normalize(cross(dFdx(eyePosition), dFdy(eyePosition)));
}

// A matte surface in a colour of the palette: where the light falls straight on it, it is as on the scale.
vec3 painted(float value) {
    float at = clamp(most > 0 ? value / most : 0, 0, 1) * 9;
    int stop = min(int(at), 8);
    vec3 n = ofTriangle();
    vec3 light = mix(ground, sky, .5 + .5 * dot(n, view[1].xyz)) + keyLight * clamp(dot(n, keyDirection), 0, 1);
    return toScreen(1.2 * toLinear(mix(palette[stop], palette[stop + 1], at - stop)) * light / PI);
}

// Whether the colour is that of no material.
bool isOther() {
    if (shading <= FLAT) return false;
    if (shading == NORMALS) colour = vec4(.5 + .5 * ofTriangle(), 1);
    else if (shading == EDGES) colour = edges;
    else if (shading == ERROR) colour = vec4(painted(error), 1);
    else colour = vec4(painted(255 * texelFetch(levels, firstPlace + gl_PrimitiveID).r), 1);
    return true;
}

void main() {
    if (isOther()) return;
    vec4 base = surface * linearColour;
    if (shown[COLOUR]) {
        vec4 texel = texture(images[COLOUR], places[COLOUR]);
        base.rgb *= texel.rgb;
        if (imageOpacity) base.a *= texel.a;
    }
    if (shown[OPACITY]) base.a *= one(texture(images[OPACITY], places[OPACITY]), channels[OPACITY]);

    vec3 seen = base.rgb;
    if (!unlit) {
        vec3 toEye = normalize(-eyePosition);
        // Where the file has no direction the surface faces the eye.
        vec3 n = dot(eyeNormal, eyeNormal) > 0 ? normalize(eyeNormal) : gl_FrontFacing ? toEye : -toEye;
        float side = gl_FrontFacing ? 1 : -1;
        vec3 plain = shading == FLAT ? ofTriangle() : facing(n, toEye);
        vec3 shaped = plain;
        if (shown[NORMAL]) shaped = fromImage(n, plain, side);
        else if (shown[BUMP]) shaped = bumped(plain);
        float metal = metallic;
        float rough = roughness;
        float open = 1;
        vec3 own = emission;
        if (shown[METALLIC]) metal *= one(texture(images[METALLIC], places[METALLIC]), channels[METALLIC]);
        if (shown[ROUGHNESS]) rough *= one(texture(images[ROUGHNESS], places[ROUGHNESS]), channels[ROUGHNESS]);
        if (shown[OCCLUSION])
            open += factors[OCCLUSION] * (one(texture(images[OCCLUSION], places[OCCLUSION]), channels[OCCLUSION]) - 1);
        if (shown[EMISSION]) own *= texture(images[EMISSION], places[EMISSION]).rgb;
        seen = lit(base.rgb, metal, rough, plain, shaped, toEye, open) + own;
    }
    if (base.a < cutoff) discard;
    float opacity = blended ? base.a : 1;
    // Premultiplied, so that a picture without background keeps its edges.
    colour = vec4(toScreen(toned(seen)) * opacity, opacity);
}
