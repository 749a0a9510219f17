package org.jsmesh.load;

import java.net.InetAddress;
import java.net.UnknownHostException;
import java.util.List;
import java.util.Random;

/**
 * Who a viewer is; drawn from the run's seed and the viewer's number.
 *
 * @param seed of all else that the viewer does
 * @param proxied connected through the proxy that injects faults
 * @param serverPlan leaves planning to the server
 * @param readsManifest asks for the manifest first
 * @param decodes decodes what it got and compares the mesh
 * @param source address of the viewer
 */
record ViewerProfile(
        int number,
        long seed,
        SpeedClass speed,
        double roundTripMillis,
        Model model,
        boolean proxied,
        boolean serverPlan,
        boolean readsManifest,
        boolean decodes,
        InetAddress source) {
    /** Nobody is given an archive that takes longer on the bare link. */
    private static final double LONGEST_SECONDS = 60;

    static ViewerProfile draw(int number, LoadSettings settings, List<Model> models) {
        Random random = new Random(settings.seed() * 1_000_003 + number);
        random.nextLong();
        SpeedClass speed = SpeedClass.ALL.get(number % SpeedClass.ALL.size());
        Model model;
        do model = models.get(random.nextInt(models.size()));
        while (model.bytes().length * 8 / speed.bitsPerSecond() > LONGEST_SECONDS);
        return new ViewerProfile(
                number,
                random.nextLong(),
                speed,
                10 + random.nextInt(71),
                model,
                random.nextInt(100) < settings.proxiedPercent(),
                random.nextInt(4) == 0,
                random.nextInt(8) == 0,
                random.nextInt(settings.decodeOneIn()) == 0,
                address(number));
    }

    /** Addresses of the loopback network, as limits per address are not what is tested. */
    private static InetAddress address(int number) {
        try {
            if (!System.getProperty("os.name").equals("Linux")) return InetAddress.getByName("127.0.0.1");
            return InetAddress.getByAddress(
                    new byte[] {127, 0, (byte) (1 + number / 250 % 4), (byte) (2 + number % 250)});
        } catch (UnknownHostException e) {
            throw new IllegalStateException("a numeric address", e);
        }
    }
}
