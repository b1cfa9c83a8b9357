package org.dronemap.ws.problem;

/** Problem codes of plans that cannot be accepted, changed or flown now, of follows and dispatches without a drone, and of recoveries. */
public enum OperationProblem implements ProblemCode {
    PLAN_NOT_FINISHED(ProblemCatalogueEntry.of(
            "plan-not-finished",
            RejectionKind.CONFLICT,
            "The plan is being worked out still.",
            "The plan is not finished.")),
    PLAN_WITHOUT_RESULT(ProblemCatalogueEntry.of(
            "plan-without-result",
            RejectionKind.CONFLICT,
            "The search for the plan was cancelled or failed; another one has to be asked for.",
            "The plan is not finished.")),
    PLAN_UNSAFE(ProblemCatalogueEntry.of(
            "plan-unsafe",
            RejectionKind.CONFLICT,
            "The plan breaks rules that hold now.",
            "The plan must not be flown: A zone is in the way.")),
    PLAN_EMPTY(ProblemCatalogueEntry.of(
            "plan-empty",
            RejectionKind.CONFLICT,
            "No drone has anything to do in the plan.",
            "Nobody flies in this plan.")),
    PLAN_OUTDATED(ProblemCatalogueEntry.of(
                    "plan-outdated",
                    RejectionKind.CONFLICT,
                    "A drone, or its home, is no longer where it was planned for.",
                    "“Kestrel”, or its home, is no longer where it was when this was planned; plan again.")
            .with(ProblemParameter.DRONE)),
    PLAN_OUTDATED_POOL(ProblemCatalogueEntry.of(
            "plan-without-pool",
            RejectionKind.CONFLICT,
            "Not all drones of the pool that the plan is for are free any more, and others cannot fly it.",
            "Not all drones of the plan are free any more, and others of the pool cannot fly it.")),
    PLAN_UNDER_WAY(ProblemCatalogueEntry.of(
            "plan-under-way",
            RejectionKind.CONFLICT,
            "The plan's missions are on their way, or drones wait for their start.",
            "Its missions are on their way to the drones already.")),
    PLAN_STARTS_NOBODY(ProblemCatalogueEntry.of(
            "plan-starts-nobody",
            RejectionKind.CONFLICT,
            "No drone of the plan waits for its start.",
            "Nobody of this plan waits for a start.")),
    PLAN_INCOMPLETE(ProblemCatalogueEntry.of(
            "plan-incomplete",
            RejectionKind.CONFLICT,
            "Another drone of the plan did not get its mission, so that none is started.",
            "It has its mission and was not started, since another drone of the plan has none.")),
    PLAN_STOPPED(ProblemCatalogueEntry.of(
            "plan-stopped",
            RejectionKind.CONFLICT,
            "The start of the plan was stopped before the drone's turn.",
            "It has its mission and was not started, since the start was stopped.")),
    WAYS_HOME_DO_NOT_FIT(ProblemCatalogueEntry.of(
                    "ways-home-do-not-fit",
                    RejectionKind.CONFLICT,
                    "More drones would be in the air at once than have a way home apart from each other below the"
                            + " ceiling; most says how many have.",
                    "3 of 7 drones have a way home between 20 m (the highest way) and the ceiling of 40 m above the home"
                            + " of “Kestrel”: layers are 6 m apart.")
            .with(ProblemParameter.DRONES, ProblemParameter.MOST)),
    TAKE_OFF_NOT_CLEAR(ProblemCatalogueEntry.of(
            "take-off-not-clear",
            RejectionKind.CONFLICT,
            "Another drone is in the way of the drone's take-off; it is started as soon as that is gone.",
            "It waits on the ground until another drone has left its way up.")),
    TOUR_UNDER_WAY(ProblemCatalogueEntry.of(
            "tour-under-way",
            RejectionKind.CONFLICT,
            "Another tour of the same user is being ordered.",
            "A tour of yours is being ordered already; wait for it.")),
    NO_DRONE_TO_FOLLOW(ProblemCatalogueEntry.of(
            "no-drone-to-follow",
            RejectionKind.CONFLICT,
            "No drone that the asker may command can follow now.",
            "The warehouse has no drone that you may command. Name one that you look after.")),
    NO_DRONE_TO_PLAN(ProblemCatalogueEntry.of(
            "no-drone-to-plan",
            RejectionKind.CONFLICT,
            "No drone of the pool that the asker may command can be planned with now.",
            "No drone of the pool can be planned with now. The pool has no other drone for you.")),
    NO_DRONE_TO_SEND(ProblemCatalogueEntry.of(
            "no-drone-to-send",
            RejectionKind.CONFLICT,
            "No drone of the pool that the asker may command can come now.",
            "The pool has no drone that you may command.")),
    NO_DRONE_TO_RECOVER(ProblemCatalogueEntry.of(
            "no-drone-to-recover",
            RejectionKind.CONFLICT,
            "No drone that the asker may command is in the air, or can be brought down so.",
            "No drone that you may command is in the air.")),
    RECOVERY_DOES_NOT_FIT(ProblemCatalogueEntry.of(
                    "recovery-does-not-fit",
                    RejectionKind.CONFLICT,
                    "The drones cannot all come down apart from each other; most says how many have room.",
                    "5 of 9 drones fit between 20 m and the ceiling of 120 m above their homes, 6.0 m above each other.")
            .with(ProblemParameter.DRONES, ProblemParameter.MOST)),
    RECOVERY_CHANGED(ProblemCatalogueEntry.of(
            "recovery-changed",
            RejectionKind.CONFLICT,
            "Other drones would come than the preview showed; nothing was begun.",
            "Since the preview more drones would come: Kestrel. Look at a new preview.")),
    RECOVERY_NOT_FOR_KIND(ProblemCatalogueEntry.of(
            "recovery-not-for-kind",
            RejectionKind.CONFLICT,
            "A vehicle of this kind does not stand in the air until its turn comes; it is sent home by itself.",
            "A plane does not stand in the air until its turn comes. Once the others are down, send it home by itself:"
                    + " return to launch.")),
    RECOVERY_NEEDS_TAKE_OVER(ProblemCatalogueEntry.of(
            "recovery-needs-take-over",
            RejectionKind.CONFLICT,
            "An operation of the asker, a pilot, or somebody whom the asker may overrule has the drone; takeOver takes it"
                    + " over.",
            "The follow has had control of it since 2026-03-04 05:06:07 UTC. Ask with takeOver to take it over."));

    @SuppressWarnings("ImmutableEnumChecker") // its lists never change
    private final ProblemCatalogueEntry entry;

    OperationProblem(ProblemCatalogueEntry entry) {
        this.entry = entry;
    }

    @Override
    public ProblemCatalogueEntry entry() {
        return entry;
    }
}
