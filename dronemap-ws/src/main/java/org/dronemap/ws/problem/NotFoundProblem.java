package org.dronemap.ws.problem;

/** Problem codes of things that do not exist or are hidden from the caller; answers do not tell which. */
public enum NotFoundProblem implements ProblemCode {
    DRONE("drone-unknown", "drone", ProblemParameter.DRONE),
    COMMAND("command-unknown", "command", ProblemParameter.COMMAND),
    ZONE("zone-unknown", "zone"),
    MISSION("mission-unknown", "mission"),
    PLAN("plan-unknown", "plan"),
    MISSION_RUN("mission-run-unknown", "mission run"),
    WAYPOINT("waypoint-unknown", "waypoint"),
    FOLLOW("follow-unknown", "follow"),
    DISPATCH("dispatch-unknown", "dispatch"),
    RECOVERY("recovery-unknown", "recovery"),
    VIRTUAL_DRONE("virtual-drone-unknown", "virtual drone"),
    FLIGHT("flight-unknown", "flight"),
    RECORDING("recording-unknown", "recording"),
    REPLAY("replay-unknown", "replay"),
    LOG("log-unknown", "log"),
    ENDPOINT("endpoint-unknown", "endpoint"),
    WAITING_VEHICLE("waiting-vehicle-unknown", "waiting vehicle"),
    ROBOT_KEY("robot-key-unknown", "robot key"),
    DTLS_KEY("dtls-key-unknown", "DTLS key"),
    PERSONAL_PORT("personal-port-unknown", "personal port"),
    OUTLET_CLIENT("outlet-client-unknown", "client"),
    USER("user-unknown", "user"),
    GROUP("group-unknown", "group"),
    FLEET("fleet-unknown", "fleet"),
    GRANT("grant-unknown", "grant"),
    ORGANISATION("organisation-unknown", "organisation"),
    INVITATION("invitation-unknown", "invitation"),
    ACCESS_KEY("access-key-unknown", "access key");

    @SuppressWarnings("ImmutableEnumChecker") // its lists never change
    private final ProblemCatalogueEntry entry;

    private final String noun;

    NotFoundProblem(String word, String noun) {
        this(word, noun, ProblemParameter.ID);
    }

    NotFoundProblem(String word, String noun, ProblemParameter id) {
        this.noun = noun;
        entry = ProblemCatalogueEntry.of(
                        word,
                        RejectionKind.UNKNOWN,
                        "There is no " + noun + " of this id, or the asker does not see it.",
                        sentence(noun, "x7"))
                .with(id);
    }

    private static String sentence(String noun, String id) {
        return "There is no " + noun + " " + id + ".";
    }

    String sentence(String id) {
        return sentence(noun, id);
    }

    /** What the id is told as. */
    ProblemParameter id() {
        return entry.parameters().get(0);
    }

    @Override
    public ProblemCatalogueEntry entry() {
        return entry;
    }
}
