package org.dronemap.sim.load;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.List;

/** The entry of the load programs; each prints one line of JSON at its end. See bench/README.md. */
public final class Load {
    private static final int BAD_USAGE = 2;

    private Load() {}

    private static BufferedReader lines() {
        return new BufferedReader(new InputStreamReader(System.in, StandardCharsets.US_ASCII));
    }

    public static void main(String[] words) throws IOException, InterruptedException {
        try {
            if (words.length == 0) {
                throw new IllegalArgumentException(
                        "say send, watch, check, impair, flood, attach, sink, robots or crowd");
            }
            Arguments arguments = new Arguments(List.of(Arrays.copyOfRange(words, 1, words.length)));
            System.out.println(
                    switch (words[0]) {
                        case "send" -> new Sender(arguments).run(lines(), System.out);
                        case "watch" -> new Watcher(arguments).run();
                        case "check" -> new Checker(arguments).run();
                        case "impair" -> Impairer.serve(arguments);
                        case "sink" -> new Sink(arguments).run();
                        case "flood" -> new Flooder(arguments).run();
                        case "attach" -> new Attached(arguments).run();
                        case "crowd" -> new Crowd(arguments).run(lines(), System.out);
                        case "robots" -> new RobotSender(arguments).run(lines(), System.out);
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
