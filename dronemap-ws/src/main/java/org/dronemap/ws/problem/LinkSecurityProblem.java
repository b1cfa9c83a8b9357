package org.dronemap.ws.problem;

/** Problem codes of refused changes to the MAVLink signing of a drone's links. */
public enum LinkSecurityProblem implements ProblemCode {
    KEY_IN_USE(entry(
            "link-key-in-use",
            "The vehicle uses a key already.",
            "The vehicle uses a key already; rotate it, or revoke it first.")),
    KEY_CHANGING(entry(
            "link-key-changing",
            "Another change of the vehicle's key is under way.",
            "The key of this drone is being changed already.")),
    NO_KEY(entry(
            "link-key-missing",
            "The drone has no key that could be changed.",
            "There is no key for this drone; make one first.")),
    KEY_NOT_PROVEN(entry(
            "link-key-not-proven",
            "The vehicle was never heard using its key.",
            "The vehicle was never heard using its key; install that first.")),
    LINK_NOT_SAFE(
            entry(
                    "link-not-safe",
                    "The link could be listened to, and nobody vouches for it.",
                    "The link could be listened to, and who hears the key can command the drone. Use a serial line, DTLS or a connection on this machine, or confirm that this link is safe.")),
    KEY_NOT_CHANGED(entry(
            "link-key-not-changed",
            "The vehicle was asked, was heard since, and goes on as before.",
            "The vehicle was asked 5 times and goes on as before.")),
    KEY_REFUSED(entry(
            "link-key-refused",
            "The vehicle says why it does not change its key.",
            "The vehicle says: ERROR: Won't setup signing when armed.")),
    KEY_IN_DOUBT(entry(
            "link-key-in-doubt",
            "The vehicle was asked and not heard since: which key it uses, nobody knows.",
            "The vehicle was asked 5 times and was not heard since."));

    @SuppressWarnings("ImmutableEnumChecker") // its lists never change
    private final ProblemCatalogueEntry entry;

    LinkSecurityProblem(ProblemCatalogueEntry entry) {
        this.entry = entry;
    }

    private static ProblemCatalogueEntry entry(String word, String meaning, String example) {
        return ProblemCatalogueEntry.of(word, RejectionKind.CONFLICT, meaning, example)
                .with(ProblemParameter.DRONE);
    }

    @Override
    public ProblemCatalogueEntry entry() {
        return entry;
    }
}
