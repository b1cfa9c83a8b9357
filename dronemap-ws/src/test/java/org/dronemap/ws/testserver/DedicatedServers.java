package org.dronemap.ws.testserver;

import java.util.List;

/** The classes of tests that start servers of their own, how many, and why the shared one will not do. */
public final class DedicatedServers {
    /** In one run of the module's tests. */
    public static final int MOST = 18;

    /** Each JVM that tests run in has a shared one: two, as there are on a machine of two cores. */
    public static final int SHARED = 2;

    private static final List<Own> ALL = List.of(
            new Own("AccessTest", 1, "open to the network, and its first password is changed"),
            new Own("CanaryTest", 1, "looks for secrets in all that a server logs from its start to its end"),
            new Own("SuccessfulCallTrial", 3, "signs in with a provider; three classes of tests extend it"),
            new Own("ExchangesTest", 1, "replays what was recorded on a server that had seen nothing before"),
            new Own("FloodTest", 1, "bounds the work of users, and wrong passwords shut its address out for a while"),
            new Own("HiddenDroneTest", 1, "looks for the words of one drone in all that a server tells"),
            new Own("ListedRefusalsTest", 1, "is impatient, turns crowds away, and its store goes away"),
            new Own("OidcTest", 2, "signs in with a provider, with roles of its own and with accounts that wait"),
            new Own("RegistrationPolicyTest", 3, "one for each policy of registration"),
            new Own("SlowClientsTest", 1, "bounds slow clients"),
            new Own("TlsTest", 1, "speaks TLS"));

    private DedicatedServers() {}

    /** A class by its simple name, and its most starts in one run. */
    public record Own(String name, int starts, String why) {}

    public static List<Own> all() {
        return ALL;
    }

    static int allowedTo(String name) {
        return name.equals(SharedServer.class.getSimpleName())
                ? 1
                : ALL.stream()
                        .filter(own -> own.name().equals(name))
                        .mapToInt(Own::starts)
                        .findFirst()
                        .orElse(0);
    }
}
