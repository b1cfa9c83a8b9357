package org.dronemap.ws.service;

import java.util.Set;

/**
 * Which calls leave a record, for all faces: every one, but for those that only look, named here. A sign of life of who has
 * control comes every two seconds and changes nothing that lasts; that control ends without it does leave its trace.
 */
public final class AuditRules {
    private static final Set<String> LOOKING = Set.of("GET", "HEAD", "OPTIONS");
    /** Where a browser that comes back from a provider is signed in. */
    private static final String CALLBACK = "/api/v1/session/oidc/callback";

    private static final Set<String> LEFT_OUT_OF_REST = Set.of("POST /api/v1/drones/{id}/control/heartbeat");
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
    private static final Set<String> LEFT_OUT_OF_STREAM = Set.of("ping", "subscribe");

    /**
     * Whose success another record tells: what follows a sign-in, or that of a turn at the helm, from begin to end. A followed
     * phone's positions come each second; what is steered because of them is such a turn.
     */
    private static final Set<String> TOLD_ELSEWHERE = Set.of(
            "authenticate", "steer", "letGo", "positions", "sendNewGPSLocation", "POST /api/v1/follows/{id}/positions");

    private AuditRules() {}

    public static boolean onlyLooks(String method, String path) {
        return LOOKING.contains(method) && !path.equals(CALLBACK);
    }

    /** {@code operation}: method and address as the table of who may do what has them. */
    public static boolean leavesOutRest(String operation) {
        return LEFT_OUT_OF_REST.contains(operation);
    }

    public static boolean leavesOutSoap(String operation) {
        return LEFT_OUT_OF_SOAP.contains(operation);
    }

    /** Of these only what is turned away leaves a record of its own. */
    public static boolean recordsElsewhere(String operation) {
        return TOLD_ELSEWHERE.contains(operation);
    }

    public static boolean leavesOutStream(String type) {
        return LEFT_OUT_OF_STREAM.contains(type);
    }
}
