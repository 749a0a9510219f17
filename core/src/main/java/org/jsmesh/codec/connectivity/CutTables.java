package org.jsmesh.codec.connectivity;

/**
 * Trained once on scans, machine parts and models made by hand: how much a value of a feature raises the odds that a
 * cut takes an edge in, in eighths of the natural logarithm. A value is a letter, with 'M' for 0. See {@link CutModel}
 * for the features.
 */
final class CutTables {
    private static final String[] SEEDS = {
        "QRRRTTTSSTUUVWUVPPPQRQRRTSSTSVSVNNOOOQRRTQRSXTWPLLMOORQRSQUURMQN",
        ">MLIJLMMOPOMKJIDNMLKLMMLNMLKJJICSMLLLLLLNKIIFM?EOSNMLLKLOJDFK<>B",
        "VOJFINRPLJGGLQTNJHFIMQSHFFILOQPQ",
        "FGJNPQLHKLNONJG?LNNOMIGHNNOMMJID",
        "EHJMPQLAKLNONJGGMNOOMIGCMNONMIFE",
        "?GKNMM",
        "MLNMML",
        "NLMMML",
        "MMWQOMLJKJLKLPSU",
        "MMMMIKLMNNONL"
    };

    private static final String[] GROWTH = {
        "KKKKKKKKKKKKKKKKKKKKKKKKKKKKKK>GLNOPOQSKKKKK:BIMNNQQKKKKKK/6<DDMLKKKKKKK48@IFJKKKKKKKK=BAK"
                + "OKKKKKKKKKCMCLKKKKKKKKKKKKKKKKKKKKKKKKKKKKKKAJPUXYYZWKKKKK;EJQORROKKKKKK4<?GGKPKKKKKKK2>FG"
                + "GNKKKKKKKK37DHNKKKKKKKKK9<GW",
        "GHIJKNOOSTUTVXTTHIIJKMOPSVWUVVXY",
        "KLMMMNMNLMKJJJHMMMNNMNMMLKJJHJHM",
        "KKKJKKMNOPRTUZX[MLLLLLMNOOQRRSTW",
        "EFILRUQFCFJMRSQF",
        "QNMKKJIPQNMKKJJT",
        "RRQPJGJHNNNMKJJQ",
        "EILPMNEILOLN",
        "XRPKLJVRPLKJ",
        "PPNKLLNMMMLM",
        "KJMMNNMMMMMMMMMM"
    };

    private static final char ZERO = 'M';

    private CutTables() {}

    /** The values of a feature of the edge at which a run begins. */
    static int seed(int feature, int value) {
        return SEEDS[feature].charAt(value) - ZERO;
    }

    /** The values of a feature of an edge by which a run grows. */
    static int growth(int feature, int value) {
        return GROWTH[feature].charAt(value) - ZERO;
    }
}
