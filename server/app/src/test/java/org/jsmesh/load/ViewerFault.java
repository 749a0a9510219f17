package org.jsmesh.load;

import java.util.Random;

/**
 * What a viewer does wrong in one round: nothing, or it cuts its connection, or stops reading for some time.
 *
 * @param place in the round, from 0 to 1: of its bytes for a cut, of its time for a stall
 */
record ViewerFault(boolean isCut, double place, double stallMillis) {
    private static final ViewerFault NONE = new ViewerFault(false, 0, 0);

    static ViewerFault draw(Random random, LoadSettings settings) {
        if (random.nextInt(100) >= settings.faultPercent()) return NONE;
        if (random.nextBoolean()) return new ViewerFault(true, random.nextDouble(), 0);
        double place = random.nextDouble();
        return new ViewerFault(false, place, (.5 + 2.5 * random.nextDouble()) * settings.waitMillis());
    }

    boolean isStall() {
        return stallMillis > 0;
    }
}
