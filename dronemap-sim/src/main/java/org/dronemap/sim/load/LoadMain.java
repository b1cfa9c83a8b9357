package org.dronemap.sim.load;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.List;

/**
 * The entry point of the load test programs that the bench runs; each prints one line of JSON at its end. See
 * bench/README.md.
 */
public final class LoadMain {
    private static final int BAD_USAGE = 2;

    private LoadMain() {}

    private static BufferedReader lines() {
        return new BufferedReader(new InputStreamReader(System.in, StandardCharsets.US_ASCII));
    }

    public static void main(String[] words) throws IOException, InterruptedException {
        try {
            if (words.length == 0) {
                throw new IllegalArgumentException(
                        "say send, watch, check, impair, flood, attach, sink, robots or crowd");
            }
            LoadArguments arguments = new LoadArguments(List.of(Arrays.copyOfRange(words, 1, words.length)));
            System.out.println(
                    switch (words[0]) {
                        case "send" -> new VehicleLoadSender(arguments).run(lines(), System.out);
                        case "watch" -> new StreamLatencyWatcher(arguments).run();
                        case "check" -> new RecordingChecker(arguments).run();
                        case "impair" -> Impairer.serve(arguments);
                        case "sink" -> new DatagramSink(arguments).run();
                        case "flood" -> new Flooder(arguments).run();
                        case "attach" -> new GroundStationLoad(arguments).run();
                        case "crowd" -> new StreamViewers(arguments).run(lines(), System.out);
                        case "robots" -> new RobotLoadSender(arguments).run(lines(), System.out);
                        default ->
                            throw new IllegalArgumentException("'" + words[0]
                                    + "' is none of send, watch, check, impair, flood, attach, sink, robots, crowd");
                    });
        } catch (IllegalArgumentException e) {
            System.err.println(e.getMessage());
            System.exit(BAD_USAGE);
        }
    }
}
