package org.dronemap.ws.problem;

/** Problem codes of requests that the server cannot carry out now, or refuses because there are too many. */
public enum ServerProblem implements ProblemCode {
    BUDGET_SPENT(ProblemCatalogueEntry.of(
                    "budget-spent",
                    RejectionKind.THROTTLED,
                    "The user asked for more work of this kind than one user may for a while.",
                    "More than 20 commands a second for a while; wait 2 s and try again.")
            .with(ProblemParameter.WHAT, ProblemParameter.RETRY_AFTER_SECONDS)),
    ATTEMPTS_SPENT(ProblemCatalogueEntry.of(
                    "attempts-spent",
                    RejectionKind.THROTTLED,
                    "It was tried too often, such as to sign in by a wrong password.",
                    "Too many wrong passwords; wait 8 s and try again.")
            .with(ProblemParameter.RETRY_AFTER_SECONDS)),
    SIGN_INS_CROWDED(ProblemCatalogueEntry.of(
                    "sign-ins-crowded",
                    RejectionKind.THROTTLED,
                    "More people sign in at this moment than passwords can be checked of.",
                    "Too many people are signing in at this moment; wait 2 s and try again.")
            .with(ProblemParameter.RETRY_AFTER_SECONDS)),
    ADDRESS_CROWDED(ProblemCatalogueEntry.of(
                    "address-crowded",
                    RejectionKind.THROTTLED,
                    "Too many requests of one address of the network are being answered.",
                    "More than 100 requests of your address are being answered; wait 1 s and try again.")
            .with(ProblemParameter.MOST, ProblemParameter.RETRY_AFTER_SECONDS)),
    STREAMS_SPENT(ProblemCatalogueEntry.of(
                    "streams-spent",
                    RejectionKind.THROTTLED,
                    "The user has as many streams open as one may have.",
                    "As many streams are open as one user may have (20); close one first.")
            .with(ProblemParameter.MOST)),
    WAITS_SPENT(ProblemCatalogueEntry.of(
                    "waits-spent",
                    RejectionKind.THROTTLED,
                    "As many requests of the user wait for events as one may have waiting.",
                    "As many requests wait for events as one user may have (50); wait 1 s and try again.")
            .with(ProblemParameter.MOST, ProblemParameter.RETRY_AFTER_SECONDS)),
    LIMIT_REACHED(ProblemCatalogueEntry.of(
                    "limit-reached",
                    RejectionKind.CONFLICT,
                    "There are as many of these already as there may be.",
                    "There are 200 grants; take back some first.")
            .with(ProblemParameter.WHAT)
            .maybe(ProblemParameter.MOST)),
    SERVER_BUSY(ProblemCatalogueEntry.of(
                    "server-busy",
                    RejectionKind.UNAVAILABLE,
                    "As much waits to be worked on as may wait; it passes.",
                    "Too many clients are connected.")
            .with(ProblemParameter.WHAT)),
    STORE_UNREACHABLE(ProblemCatalogueEntry.of(
            "store-unreachable",
            RejectionKind.UNAVAILABLE,
            "What the server keeps cannot be read or written now.",
            "What the server keeps cannot be reached or written at the moment; drones fly on. Try again later.")),
    DISK_FULL(ProblemCatalogueEntry.of(
            "disk-full",
            RejectionKind.UNAVAILABLE,
            "There is no room on the server's disk.",
            "There is no room on the server's disk at the moment; drones fly on. Try again later.")),
    CHANGE_NOT_KEPT(
            ProblemCatalogueEntry.of(
                    "change-not-kept",
                    RejectionKind.UNAVAILABLE,
                    "The change is in force, but could not be written down.",
                    "Control has changed as you asked, but that could not be written down: should the server be started anew now, it may be as it was before.")),
    RIGHTS_NOT_KNOWN(ProblemCatalogueEntry.of(
            "rights-not-known",
            RejectionKind.UNAVAILABLE,
            "What the asker may do cannot be looked up now.",
            "Your rights are not known; try again.")),
    PROVIDER_UNREACHABLE(ProblemCatalogueEntry.of(
                    "provider-unreachable",
                    RejectionKind.UNAVAILABLE,
                    "The other provider of sign-ins does not answer.",
                    "Example ID cannot be asked at the moment; try again later.")
            .with(ProblemParameter.PROVIDER)),
    OUTCOME_NOT_KNOWN(ProblemCatalogueEntry.of(
            "outcome-not-known",
            RejectionKind.UNAVAILABLE,
            "The call is carried out, and its outcome took longer than anybody may wait.",
            "The outcome is not known yet; ask for it later.")),
    NOT_AVAILABLE(ProblemCatalogueEntry.of(
            "not-available",
            RejectionKind.UNAVAILABLE,
            "The server does not get to requests now.",
            "Not possible at the moment.")),
    SERVER_FAILED(ProblemCatalogueEntry.of(
            "server-failed",
            RejectionKind.BROKEN,
            "A fault of the server; its log tells more.",
            "Something went wrong inside the server; its log has the details."));

    @SuppressWarnings("ImmutableEnumChecker") // its lists never change
    private final ProblemCatalogueEntry entry;

    ServerProblem(ProblemCatalogueEntry entry) {
        this.entry = entry;
    }

    @Override
    public ProblemCatalogueEntry entry() {
        return entry;
    }
}
