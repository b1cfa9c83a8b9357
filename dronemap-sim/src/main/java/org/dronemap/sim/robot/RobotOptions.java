package org.dronemap.sim.robot;

import java.net.URI;
import java.util.Set;
import org.dronemap.sim.link.ServerAddress;
import org.jspecify.annotations.Nullable;

/**
 * The options of simulated ROSLink robots: number, kind, links, rates and quirks.
 *
 * @param kind rover, drone or mixed
 * @param web their WebSocket, beside UDP; null: none
 * @param first of the first one; each one more has the next system id
 * @param motionHertz how often each says where it is
 * @param cloudPatienceSeconds after such a silence of a server that it has heard it stops, or lands; 0: it goes on, as public
 *     bridges do
 */
public record RobotOptions(
        int count,
        String kind,
        ServerAddress server,
        @Nullable URI web,
        Identity first,
        double motionHertz,
        double cloudPatienceSeconds,
        Set<BridgeQuirk> quirks) {
    public static final String HELP = """
            Simulated robots that speak ROSLink: dronemap-sim --roslink …
              --count N                robots, 1 to 1000 (default 1)
              --kind KIND              rover (in a room with a map, range finder and camera), drone (behind mavros) or mixed
              --connect ADDRESS        udp://HOST:PORT (default udp://127.0.0.1:25500)
              --web URL                speak by WebSocket as well: ws://HOST:9090/, with {key} and {owner} filled in
              --sysid FIRST            system id of the first one, 0 to 65535 (default 1)
              --key KEY                what it shows of itself (default 1243-0000-0000-FGFG)
              --owner OWNER            its owner's id (default: none)
              --rate HERTZ             how often it says where it is, 0.5 to 20 (default 5; bridges: 0.5)
              --cloud-patience SECONDS stop (rover) or land (drone) after such a silence of a server that it has heard
                                       (1 to 600; default 0: go on, as public bridges do)
              --quirks A,B             repeats-twist, number-key, text-owner, status-is-heartbeat, counts-each-kind,
                                       beats-on-both, broken-lines, payload-shape, dies-of-stop, ignores-orders
            """;

    public RobotOptions {
        quirks = Set.copyOf(quirks);
        if (quirks.contains(BridgeQuirk.NUMBER_KEY) && !first.key().matches("\\d{1,18}")) {
            throw new IllegalArgumentException(
                    "--quirks number-key wants a --key that is a number, not '" + first.key() + "'");
        }
        if (server.tcp()) {
            throw new IllegalArgumentException("robots speak by udp://, not by tcp://");
        }
    }

    /** Quirks as they are written on a command line. */
    public static Set<BridgeQuirk> quirks(String text) {
        return BridgeQuirk.of(text);
    }

    /** The identity that a robot shows; {@code owner} null: none. */
    public record Identity(
            int systemId, String key, @Nullable String owner) {
        Identity plus(int number) {
            return new Identity(systemId + number, key, owner);
        }
    }
}
