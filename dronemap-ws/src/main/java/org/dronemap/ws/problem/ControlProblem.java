package org.dronemap.ws.problem;

/** Problem codes of requests about the control of a drone that do not fit who has it or asks for it. */
public enum ControlProblem implements ProblemCode {
    NOT_HELD(ProblemCatalogueEntry.of(
                    "control-not-held",
                    RejectionKind.CONFLICT,
                    "Who gives control back, hands it over or refuses it does not have it.",
                    "You do not have control. Nobody has control; take it.")
            .with(ProblemParameter.DRONE)
            .maybe(ProblemParameter.HOLDER, ProblemParameter.HELD_SINCE)),
    OWN(ProblemCatalogueEntry.of(
                    "control-own",
                    RejectionKind.CONFLICT,
                    "Who hands control over would hand it to the same user.",
                    "You have control already.")
            .with(ProblemParameter.DRONE)),
    REQUESTS_FULL(ProblemCatalogueEntry.of(
                    "control-requests-full",
                    RejectionKind.CONFLICT,
                    "So many wait for an answer to their request for control that nobody else may ask.",
                    "Too many have asked for control already. mia has had control of it since 2026-03-04 05:06:07 UTC.")
            .with(ProblemParameter.DRONE)
            .maybe(ProblemParameter.HOLDER, ProblemParameter.HELD_SINCE)),
    NOT_ASKED(ProblemCatalogueEntry.of(
                    "control-not-asked-for",
                    RejectionKind.CONFLICT,
                    "The user who would get control, or a refusal, does not ask for it.",
                    "mia does not ask for control (any more).")
            .with(ProblemParameter.DRONE)),
    NOT_TAKEN(ProblemCatalogueEntry.of(
                    "control-not-taken",
                    RejectionKind.CONFLICT,
                    "Control came with a command, so that no heartbeat keeps it.",
                    "Take control first: this one came with a command and needs no heartbeat.")
            .with(ProblemParameter.DRONE));

    @SuppressWarnings("ImmutableEnumChecker") // its lists never change
    private final ProblemCatalogueEntry entry;

    ControlProblem(ProblemCatalogueEntry entry) {
        this.entry = entry;
    }

    @Override
    public ProblemCatalogueEntry entry() {
        return entry;
    }
}
