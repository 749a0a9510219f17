"""How likely the decisions are that a split is made of. Each decodes one of them, given what is known."""

from collections import namedtuple

from .entropy import Context, Contexts

# Trained values of features of the edge at which a run begins, and of one over which it grows.
SEEDS = (
    "QRRRTTTSSTUUVWUVPPPQRQRRTSSTSVSVNNOOOQRRTQRSXTWPLLMOORQRSQUURMQN",
    ">MLIJLMMOPOMKJIDNMLKLMMLNMLKJJICSMLLLLLLNKIIFM?EOSNMLLKLOJDFK<>B",
    "VOJFINRPLJGGLQTNJHFIMQSHFFILOQPQ",
    "FGJNPQLHKLNONJG?LNNOMIGHNNOMMJID",
    "EHJMPQLAKLNONJGGMNOOMIGCMNONMIFE",
    "?GKNMM",
    "MLNMML",
    "NLMMML",
    "MMWQOMLJKJLKLPSU",
    "MMMMIKLMNNONL",
)
GROWTH = (
    "KKKKKKKKKKKKKKKKKKKKKKKKKKKKKK>GLNOPOQSKKKKK:BIMNNQQKKKKKK/6<DDMLKKKKKKK48@IFJKKKKKKKK=BAKOKKKKKKKKKCMCL"
    "KKKKKKKKKKKKKKKKKKKKKKKKKKKKKKAJPUXYYZWKKKKK;EJQORROKKKKKK4<?GGKPKKKKKKK2>FGGNKKKKKKKK37DHNKKKKKKKKK9<GW",
    "GHIJKNOOSTUTVXTTHIIJKMOPSVWUVVXY",
    "KLMMMNMNLMKJJJHMMMNNMNMMLKJJHJHM",
    "KKKJKKMNOPRTUZX[MLLLLLMNOOQRRSTW",
    "EFILRUQFCFJMRSQF",
    "QNMKKJIPQNMKKJJT",
    "RRQPJGJHNNNMKJJQ",
    "EILPMNEILOLN",
    "XRPKLJVRPLKJ",
    "PPNKLLNMMMLM",
    "KJMMNNMMMMMMMMMM",
)
LEVELS = 64
FIRST_COUNT = 6

# shape, 0 to 63; length, 0 to 7, among those of the other edges; valence of the neighbour at its end
Edge = namedtuple("Edge", "shape length valence")


def _first(level):
    """The probability with which contexts of a level begin."""
    odds = 1.2062302494
    for _ in range(level - 32 if level >= 32 else 31 - level):
        odds *= 1.4549914146182013
    p = (odds if level >= 32 else 1) / (1 + odds)
    return max(48, min(65487, int(p * 65536)))


class _Levels(dict):
    """Contexts by what they depend on, the level last."""

    FIRST = tuple(_first(level) for level in range(LEVELS))

    def __missing__(self, key):
        context = self[key] = Context(self.FIRST[key[-1]], FIRST_COUNT)
        return context


def _level(tables, indices):
    total = sum(ord(table[i]) - ord("M") for table, i in zip(tables, indices))
    return max(0, min(LEVELS - 1, (total + 96) // 3))


class Cuts:
    def __init__(self):
        self.splits_a = Contexts()
        self.splits_b = Contexts()
        self.singles = Contexts()
        self.slots = Contexts()
        self.seeds = _Levels()
        self.growth = _Levels()

    def splits(self, decoder, again, age, valence, free, flags):
        """Does a vertex split (again)? flags: the last four such bits."""
        by = min(12, valence), min(12, free)
        return decoder.bit2(self.splits_a[again, by, flags], self.splits_b[again, age, by])

    def single(self, decoder, valence, shape):
        """Is the run a single face? shape: that of the best edge."""
        return decoder.bit(self.singles[min(12, valence), shape // 2])

    def slot(self, decoder, first, second):
        """Is it this face? first, second: the valences of its neighbours."""
        return decoder.bit(self.slots[min(7, first), min(7, second)])

    def seed(self, decoder, refused, left, gap, edges):
        """Does the run begin at an edge? edges: valence of v; the edge, the one before, the one behind."""
        valence, edge, low, high = edges
        r = min(3, refused)
        indices = (
            r * 16 + gap,
            r * 16 + edge.shape // 4,
            r * 8 + edge.length,
            r * 8 + low.length,
            r * 8 + high.length,
            _valence(edge),
            _valence(low),
            _valence(high),
            min(15, left),
            min(12, valence),
        )
        return decoder.bit(self.seeds[min(7, refused), min(7, left), _level(SEEDS, indices)])

    def grows(self, decoder, side, faces, extra, edges):
        """Does the run grow over an edge? edges: valence of v; the edge, the one beyond, the other end."""
        valence, edge, beyond, end = edges
        count = min(7, faces)
        indices = [(8 * side + count) * 13 + min(12, valence)]
        indices += [side * 16 + e.shape // 4 for e in (edge, beyond, end)]
        indices += [side * 8 + e.length for e in (edge, beyond, end)]
        indices += [side * 6 + _valence(e) for e in (edge, beyond, end)]
        indices.append(side * 8 + extra)
        return decoder.bit(self.growth[side, count, _level(GROWTH, indices)])


def _valence(edge):
    return max(0, min(5, edge.valence - 3))
