package org.jsmesh.codec.connectivity;

/**
 * Trained once on scans, machine parts and models made by hand: how much a value of a feature raises the odds that a
 * cut takes an edge in, in eighths of the natural logarithm. A value is a letter, with 'M' for 0. See {@link CutModel}
 * for the features.
 */
final class CutTables {
    private static final char ZERO = 'M';
    private static final byte[][] SEEDS = numbers(
            "QRRRTTTSSTUUVWUVPPPQRQRRTSSTSVSVNNOOOQRRTQRSXTWPLLMOORQRSQUURMQN",
            ">MLIJLMMOPOMKJIDNMLKLMMLNMLKJJICSMLLLLLLNKIIFM?EOSNMLLKLOJDFK<>B",
            "VOJFINRPLJGGLQTNJHFIMQSHFFILOQPQ",
            "FGJNPQLHKLNONJG?LNNOMIGHNNOMMJID",
            "EHJMPQLAKLNONJGGMNOOMIGCMNONMIFE",
            "?GKNMM",
            "MLNMML",
            "NLMMML",
            "MMWQOMLJKJLKLPSU",
            "MMMMIKLMNNONL");

    private static final byte[][] GROWTH = numbers(
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
            "KJMMNNMMMMMMMMMM");

    private CutTables() {}

    private static byte[][] numbers(String... features) {
        byte[][] numbers = new byte[features.length][];
        for (int f = 0; f < features.length; f++) {
            numbers[f] = new byte[features[f].length()];
            for (int i = 0; i < numbers[f].length; i++) numbers[f][i] = (byte) (features[f].charAt(i) - ZERO);
        }
        return numbers;
    }

    /** The values of a feature of the edge at which a run begins. */
    static int seed(int feature, int value) {
        return SEEDS[feature][value];
    }

    /** The values of a feature of an edge by which a run grows. */
    static int growth(int feature, int value) {
        return GROWTH[feature][value];
    }
}
