package org.dronemap.ws.service;

import java.util.Set;

/**
 * The calls of SOAP that leave a record: every one, but for those that only look, named here; of REST the handlers say so, and
 * of the stream its kinds of requests. A sign of life of who has control comes every two seconds and changes nothing that lasts; that control ends
 * without it does leave its trace.
 */
public final class AuditRules {
    private static final Set<String> LOOKING = Set.of("GET", "HEAD", "OPTIONS");
    private static final Set<String> LEFT_OUT_OF_SOAP = Set.of(
            "getDronesList",
            "getDrone",
            "downloadMission",
            "getParameters",
            "getCommand",
            "getControl",
            "getPlan",
            "getRobotKeysList",
            "getRunsList",
            "getRun",
            "getVirtualDronesList",
            "getVirtualDrone",
            "getFlightsList",
            "getFlight",
            "getFollowsList",
            "getFollow",
            "controlHeartbeat");
    /**
     * Whose success another record tells: a followed phone's positions come each second, and what is steered because of them
     * is one turn, from begin to end.
     */
    private static final Set<String> TOLD_ELSEWHERE = Set.of("sendNewGPSLocation");

    private AuditRules() {}

    /** {@code method}: of HTTP. */
    public static boolean onlyLooks(String method) {
        return LOOKING.contains(method);
    }

    public static boolean leavesOutSoap(String operation) {
        return LEFT_OUT_OF_SOAP.contains(operation);
    }

    /** Of these only what is turned away leaves a record of its own. */
    public static boolean recordsElsewhere(String operation) {
        return TOLD_ELSEWHERE.contains(operation);
    }
}
