package org.dronemap.sim;

import java.util.List;
import java.util.Map;
import org.dronemap.sim.link.ServerAddress;
import org.dronemap.sim.physics.LocalFrame;

/**
 * The options of the simulator's command line, speeds in m/s, times in seconds of the vehicles' clocks. Speeds in m/s,
 * times in seconds of the vehicles' clocks.
 */
record SimulatorOptions(
        int count,
        LocalFrame home,
        int firstSystemId,
        int firstHardware,
        ServerAddress server,
        String personality,
        double speedup,
        long seed,
        double rateHertz,
        double windSpeed,
        int controlPort,
        double readyAfterSeconds,
        boolean mavlink1,
        boolean stickLow,
        boolean usb,
        int parameters,
        Map<String, Double> presets,
        boolean asleep,
        SimulatorOddities oddities) {

    static final String HELP = """
            Simulated vehicles that speak MAVLink over real sockets.
              --count N                vehicles, 1 to 10000 (default 1); beyond 254 system ids repeat on other ports
              --home LAT,LON[,ALT]     where the first one stands, altitude in metres AMSL (default 47.3977,8.5456,488)
              --sysid FIRST            system id of the first one, 1 to 254 (default 1)
              --hardware FIRST         number of the first one's board, 1 to 1000000 (default: its system id)
              --connect ADDRESS        udp://HOST:PORT or tcp://HOST:PORT (default udp://127.0.0.1:14550)
              --personality KIND       arducopter, arduplane, quadplane, ardurover, px4 or mixed (default arducopter)
              --speedup X              simulated seconds a second, 0.1 to 50 (default 1)
              --seed N                 same seed, same wind (default 1)
              --rate HERTZ             telemetry before anybody asks, 0 to 50 (default: as the autopilot does it)
              --wind SPEED             mean wind in m/s, 0 to 20 (default 0)
              --control PORT           faults on order at this loopback port, 0 for none (default 0); say "help" there
              --ready-after SECONDS    until the position estimate stands, 0 to 600 (default 5; a real one takes 41)
              --stick low|mid          throttle stick of the remote control (default mid)
              --parameters N           fills the table of parameters up to so many, 0 to 5000 (default 0)
              --parameter NAME=VALUE   sets that parameter from the start; may be given more than once
              --noise SEED             sensors as they are: place, height and home a little wrong, wind; 0 for none
              --companions NAMES       others on the link: gimbal, camera, computer, adsb, station; commas between
              --cells N                cells of the battery told one by one, 0 to 14 (default 0: their sum)
              --asleep                 they say and hear nothing until the control port is told to wake them
              --mavlink1               speak MAVLink 1
              --roslink                robots of another kind instead: their options are below
              --usb                    the link is the first channel: unsigned messages pass in spite of a signing key
              --help                   this text
            """;

    static SimulatorOptions defaults() {
        return new SimulatorOptions(
                1,
                new LocalFrame(47.3977, 8.5456, 488),
                1,
                0,
                new ServerAddress(false, "127.0.0.1", 14550),
                "arducopter",
                1,
                1,
                -1,
                0,
                0,
                5,
                false,
                false,
                false,
                0,
                Map.of(),
                false,
                SimulatorOddities.NONE);
    }

    /**
     * Reads a command line.
     *
     * @throws IllegalArgumentException with a sentence that names the option and what it takes
     */
    static SimulatorOptions parse(List<String> arguments) {
        CommandLineReader reader = new CommandLineReader(arguments);
        SimulatorOptions d = defaults();
        SimulatorOptions options = new SimulatorOptions(
                (int) reader.integer("--count", d.count, 1, 10_000),
                reader.home("--home", d.home),
                (int) reader.integer("--sysid", d.firstSystemId, 1, 254),
                (int) reader.integer("--hardware", d.firstHardware, 1, 1_000_000),
                reader.server("--connect", d.server),
                reader.choice(
                        "--personality",
                        d.personality,
                        List.of("arducopter", "arduplane", "quadplane", "ardurover", "px4", "mixed")),
                reader.number("--speedup", d.speedup, 0.1, 50),
                reader.integer("--seed", d.seed, Long.MIN_VALUE, Long.MAX_VALUE),
                reader.number("--rate", d.rateHertz, 0, 50),
                reader.number("--wind", d.windSpeed, 0, 20),
                (int) reader.integer("--control", d.controlPort, 0, 65_535),
                reader.number("--ready-after", d.readyAfterSeconds, 0, 600),
                reader.flag("--mavlink1"),
                reader.choice("--stick", "mid", List.of("low", "mid")).equals("low"),
                reader.flag("--usb"),
                (int) reader.integer("--parameters", d.parameters, 0, 5_000),
                reader.numbersByName("--parameter"),
                reader.flag("--asleep"),
                SimulatorOddities.parse(reader));
        reader.finish();
        return options;
    }
}
