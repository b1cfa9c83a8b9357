package org.dronemap.cognitive.operation.dispatch;

import java.time.Duration;
import java.time.Instant;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import org.dronemap.cognitive.operation.CopterEndurance;
import org.dronemap.cognitive.operation.TakeOffPatience;
import org.dronemap.cognitive.operation.dispatch.DispatchInput.Look;
import org.dronemap.core.operation.OperationAction;
import org.dronemap.core.separation.GiveWay;
import org.jspecify.annotations.Nullable;

/** Decides what the drone of a dispatch does next on its way there, and when another one has to come in its place. */
final class LeadFlight {
    /** So long without a sign of it, and it is lost. */
    static final int LOST_SECONDS = 5;

    /** So near the place it is there, over ground and in height. */
    private static final double THERE_METERS = 5;

    /** So long it may take beyond what is reckoned: ways are longer, and winds stronger. */
    private static final double LONGER = 3;

    private static final double SPARE_SECONDS = 60;
    /** So soon after a restart a drone that comes home does so since it had missed the cloud. */
    private static final Duration MISSED = Duration.ofSeconds(60);

    /** So long control may take to go over, until that is asked for once more. */
    private static final Duration HANDING_OVER = Duration.ofSeconds(2);

    private final DispatchState state;
    private final DispatchLeg lead;
    private final Look look;
    private final Instant at;
    private final List<OperationAction<DispatchInput>> actions;

    /** {@code actions}: what it is told is added there. */
    LeadFlight(
            DispatchState state,
            DispatchLeg lead,
            Look look,
            Instant at,
            List<OperationAction<DispatchInput>> actions) {
        this.state = state;
        this.lead = lead;
        this.look = look;
        this.at = at;
        this.actions = actions;
    }

    DispatchState next() {
        if (state.stage() == DispatchStage.HERE) {
            return here();
        }
        if (look.control().owned() && state.stage() == DispatchStage.ARRIVED) {
            return state.to(
                    DispatchStage.HERE,
                    at,
                    lead.name() + " is here: control is yours. It holds until you fly it, and comes home when you give"
                            + " control back or are away.");
        }
        return lost().orElseGet(this::onTheWay);
    }

    /** Somebody has taken it, or it cannot be led any more. */
    private Optional<DispatchState> lost() {
        if (look.control().whyNotHeld() != null) {
            String words = lead.name() + " was taken: " + look.control().whyNotHeld();
            return Optional.of(state.stage() == DispatchStage.ARRIVED ? state.end(at, words) : replaced(words, false));
        }
        if (look.control().whyNotAllowed() != null) {
            return Optional.of(calledHome(look.control().whyNotAllowed() + " " + lead.name() + " comes home."));
        }
        if (look.place().silentSeconds() >= LOST_SECONDS) {
            return Optional.of(replaced("Contact with " + lead.name() + " was lost.", true));
        }
        if (look.place().silentSeconds() > 0) {
            return Optional.of(state.noted("There is no contact with " + lead.name() + "."));
        }
        if (look.fallingLink() != null && look.flight().airborne() && state.stage() != DispatchStage.ARRIVED) {
            return Optional.of(
                    replaced(lead.name() + " flies home before its link is lost. " + look.fallingLink(), true));
        }
        if (lead.failure() != null) {
            return Optional.of(replaced(lead.failure(), true));
        }
        if (look.flight().steered() && look.flight().airborne()) {
            return Optional.of(replaced(
                    lead.name() + " was taken: a pilot flies it in "
                            + look.flight().mode() + ".",
                    false));
        }
        return lowBattery().map(words -> replaced(words, true));
    }

    private Optional<String> lowBattery() {
        Integer percent = look.place().batteryPercent();
        Double home = look.place().homeMeters();
        double back = home == null ? 0 : CopterEndurance.percentBack(home);
        return percent == null || percent >= CopterEndurance.RESERVE_PERCENT + back
                ? Optional.empty()
                : Optional.of(String.format(
                        Locale.ROOT,
                        "%s flies home: its battery has %d %%, the way takes some %.0f %%, and %d %% are kept.",
                        lead.name(),
                        percent,
                        back,
                        CopterEndurance.RESERVE_PERCENT));
    }

    private DispatchState onTheWay() {
        GiveWay give = look.giveWay();
        if (give != null && isBlocked()) {
            return replaced(TakeOffPatience.words(lead.name(), give), true);
        }
        if (isLate()) {
            String why = look.giveWay() == null
                    ? " takes much longer than it should."
                    : " cannot come: " + look.giveWay().toName() + " does not leave its way.";
            return replaced(lead.name() + why, true);
        }
        LegCommands commands = new LegCommands(state, lead);
        DispatchState next = switch (state.stage()) {
            case CHOSEN -> start(commands, state.to(DispatchStage.STARTING, at, lead.name() + " starts."));
            case STARTING -> starting(commands);
            case EN_ROUTE -> enRoute(commands);
            case ARRIVED -> arrived();
            case HERE, SEARCHING, RETURNING, OVER -> state;
        };
        actions.addAll(commands.actions());
        return next;
    }

    /** Somebody waits, and another drone may have a free way up. */
    private boolean isBlocked() {
        return state.stage() == DispatchStage.STARTING
                && waitsOnTheGround() != null
                && TakeOffPatience.isOver(state.since(), at);
    }

    private boolean isLate() {
        return state.stage() != DispatchStage.ARRIVED
                && Duration.between(state.since(), at).toSeconds()
                        > SPARE_SECONDS
                                + LONGER
                                        * CopterEndurance.secondsToCome(
                                                away(), state.order().heightMeters());
    }

    private double away() {
        Double away = look.place().awayMeters();
        return away == null ? 0 : away;
    }

    private DispatchState start(LegCommands commands, DispatchState next) {
        commands.start(look, at);
        return next.withLead(commands.leg());
    }

    private DispatchState starting(LegCommands commands) {
        if (look.flight().airborne() && look.flight().homing() && !isMissed()) {
            return replaced(lead.name() + " went into " + look.flight().mode() + ".", true);
        }
        if (!look.flight().guided() && look.flight().orders() == null) {
            return replaced(lead.name() + " has no mode in which it can be led.", true);
        }
        if (!commands.isUp(look)) {
            return start(commands, state.noted(waitsOnTheGround()));
        }
        commands.go(at);
        return state.to(DispatchStage.EN_ROUTE, at, lead.name() + " is in the air and comes.")
                .withLead(commands.leg());
    }

    private DispatchState enRoute(LegCommands commands) {
        Optional<String> why = notLed();
        if (why.isPresent()) {
            return isMissed() && look.flight().airborne()
                    ? state.withLead(lead.anew())
                            .to(DispatchStage.STARTING, at, lead.name() + " had missed the cloud; it comes again.")
                            .restarted(state.restartedAt())
                    : replaced(why.get(), true);
        }
        if (isThere()) {
            actions.add(new OperationAction.HandOver<>(lead.drone()));
            return state.to(DispatchStage.ARRIVED, at, lead.name() + " is there.");
        }
        if (look.standsAside()) {
            return state.noted(look.aside(lead.name())).withLead(lead.standing());
        }
        commands.go(at);
        return state.noted(null).withLead(commands.leg());
    }

    private @Nullable String waitsOnTheGround() {
        return look.giveWay() == null || look.flight().armed()
                ? null
                : look.giveWay().sentence(lead.name());
    }

    /** It comes home since it had not heard the cloud for a while. */
    private boolean isMissed() {
        return look.flight().homing()
                && state.restartedAt() != null
                && Duration.between(state.restartedAt(), at).compareTo(MISSED) < 0;
    }

    private Optional<String> notLed() {
        if (!look.flight().airborne()) {
            return Optional.of(lead.name() + " has landed on its way.");
        }
        return look.flight().mode() == null || look.flight().guided()
                ? Optional.empty()
                : Optional.of(lead.name() + " went into " + look.flight().mode() + ".");
    }

    private boolean isThere() {
        Double away = look.place().awayMeters();
        Double height = look.place().heightMeters();
        return lead.going()
                && away != null
                && away <= THERE_METERS
                && (height == null || Math.abs(height - state.order().heightMeters()) <= THERE_METERS);
    }

    /** The dispatch has control still, as after a restart in that very moment: it gives it once more. */
    private DispatchState arrived() {
        Optional<String> why = notLed();
        if (why.isPresent()) {
            return replaced(why.get(), true);
        }
        Instant asked = state.restartedAt() == null ? state.since() : state.restartedAt();
        if (Duration.between(asked, at).compareTo(HANDING_OVER) < 0) {
            return state;
        }
        actions.add(new OperationAction.HandOver<>(lead.drone()));
        return state.restarted(at);
    }

    /** Left to whoever has it: the rules for drones in a person's hand hold, as for any other. */
    private DispatchState here() {
        boolean silent = look.place().silentSeconds() > 0;
        if (!silent && !look.flight().armed()) {
            return state.end(at, lead.name() + " is down; it is over.");
        }
        if (look.control().owned()) {
            return state.noted(silent ? "There is no contact with " + lead.name() + "." : null);
        }
        if (!look.control().free()) {
            return state.end(at, lead.name() + " was taken: " + look.control().whyNotHeld());
        }
        String words =
                "Your control of " + lead.name() + " has ended; it holds, and flies home unless somebody takes it.";
        // Whoever calls it off gives control back first.
        return words.equals(state.log().note()) ? state.end(at, words) : state.noted(words);
    }

    private DispatchState calledHome(String words) {
        return sentHome(state).end(at, words);
    }

    /** Another one has to come; {@code flies}: this one is brought home. */
    private DispatchState replaced(String words, boolean flies) {
        DispatchState next = flies ? sentHome(state) : state.withLead(null);
        return next.failing(lead.drone()).to(DispatchStage.SEARCHING, at, words + " Another drone is looked for.");
    }

    /** One that stands there with its motors off is free at once. */
    private DispatchState sentHome(DispatchState of) {
        boolean down = !look.flight().armed() && look.place().silentSeconds() == 0;
        return down ? of.withLead(null) : of.withLeadReturning();
    }
}
