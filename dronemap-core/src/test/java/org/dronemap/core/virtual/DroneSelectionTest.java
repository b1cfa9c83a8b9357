package org.dronemap.core.virtual;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Instant;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import java.util.Random;
import java.util.Set;
import org.dronemap.core.drone.Capability;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.drone.DroneState;
import org.dronemap.core.drone.LinkState;
import org.dronemap.core.drone.VehicleKind;
import org.dronemap.core.drone.Wind;
import org.dronemap.core.geo.Geodetic;
import org.dronemap.core.virtual.VirtualFixtures.Drone;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.Test;

class DroneSelectionTest {
    private static final UnfitReason AGAINST = new UnfitReason("control-held", "ann has control of it.");
    private static final DroneSelection.ExternalCheck NONE = (drone, share) -> Optional.empty();

    @Test
    void takesTheNearestAndNamesTheRunnerUpWithBothDistances() {
        DroneChoice choice = choose(DroneRequirements.NONE, new Drone("far", 620), new Drone("near", 220))
                .orElseThrow();

        assertThat(choice.sentence(id -> "“" + id + "”"))
                .startsWith("“near” was chosen: 200 m from the first waypoint, the runner-up “far” 600 m from the first"
                        + " waypoint. The mission takes some ")
                .contains("5 m/s and 5 % a minute assumed");
        assertThat(choice.anonymous())
                .doesNotContain("near")
                .doesNotContain("far")
                .contains("200 m");
    }

    @Test
    void takesTheFullerBatteryOfTwoThatAreAsFarAndNamesTheBetterOfTheOthersAsRunnerUp() {
        Drone used = new Drone("a-used", 230);
        used.percent = 70;
        Drone fuller = new Drone("b-fuller", 230);
        fuller.percent = 80;
        Drone full = new Drone("c-full", 230);
        full.percent = 95;

        DroneChoice choice = choose(DroneRequirements.NONE, used, full, fuller).orElseThrow();

        assertThat(choice.chosen()).isEqualTo(full.id);
        assertThat(choice.runnerUp()).isEqualTo(fuller.id);
        assertThat(choice.deciding()).isEqualTo(SelectionCriterion.BATTERY_LEFT);
        assertThat(choice.chosenValue()).isGreaterThan(choice.otherValue());
        assertThat(choice.sentence(id -> "“" + id + "”"))
                .startsWith(String.format(
                        "“c-full” was chosen: %.0f %% of the battery left after the mission, the runner-up “b-fuller”"
                                + " %.0f %% of the battery left after the mission.",
                        choice.chosenValue(), choice.otherValue()))
                .doesNotContain("a-used");
    }

    @Test
    void saysWhetherAnotherOneCouldHaveServed() {
        Drone near = new Drone("near", 1_030);

        assertThat(inWind(0, 4, near).sentence(DroneId::value))
                .startsWith("near was chosen: no other drone came into question.");
        Drone absent = new Drone("absent", 1_030);
        absent.link = LinkState.LOST;
        assertThat(inWind(0, 4, near, absent).sentence(DroneId::value))
                .startsWith("near was chosen: no other drone could serve.");
    }

    private static DroneChoice inWind(double fromDegrees, double speed, Drone... drones) {
        Wind wind = new Wind(fromDegrees, speed, VirtualFixtures.NOW);
        return DroneSelection.of(
                        new ServiceDemand(DroneRequirements.NONE, VirtualTour.of(VirtualFixtures.mission(3)), 0, wind),
                        Arrays.stream(drones).map(Drone::state).toList(),
                        NONE)
                .choice()
                .orElseThrow();
    }

    @Test
    void takesNoDroneThatMakesNoHeadwayAgainstTheWind() {
        Drone copter = new Drone("a-copter", 880);
        Drone plane = new Drone("b-plane", 1_030);
        plane.kind = VehicleKind.FIXED_WING;

        assertThat(inWind(0, 4, copter, plane).chosen()).as("the nearer one").isEqualTo(copter.id);
        DroneChoice slowed = inWind(0, 11, copter, plane);
        assertThat(slowed.chosen()).isEqualTo(plane.id);
        assertThat(slowed.unfit().get(0).why()).contains("no headway", "a wind of 11 m/s from 0°");
        assertThat(slowed.energy()).contains("a wind of 11 m/s from 0°, as felt in the air");
        assertThat(inWind(180, 0.4, copter).energy()).contains("no wind, as felt in the air");
    }

    @Test
    void reckonsWithTheWindThereAndBack() {
        Drone copter = new Drone("copter", 1_030);
        Drone plane = new Drone("plane", 1_030);
        plane.kind = VehicleKind.FIXED_WING;

        assertThat(minutes(copter, 0)).isEqualTo(minutes(copter, 4));
        assertThat(minutes(copter, 7))
                .as("slower against it, no faster with it")
                .isGreaterThan(minutes(copter, 4) * 1.2);
        assertThat(minutes(plane, 6)).isGreaterThan(minutes(plane, 0) * 1.2).isLessThan(minutes(plane, 0) * 1.5);
    }

    /** The waypoint lies to the north, and it stays there. */
    @Test
    void isSlowerAgainstTheWindThanBeforeIt() {
        Drone plane = new Drone("plane", 1_030);
        plane.kind = VehicleKind.FIXED_WING;
        VirtualTour northward =
                new VirtualTour(null, VirtualTour.of(VirtualFixtures.mission(1)).waypoints(), true);

        double calm = minutes(plane, northward, null);

        assertThat(minutes(plane, northward, wind(0, 6)))
                .as("from the north, in its face")
                .isGreaterThan(calm * 1.5);
        assertThat(minutes(plane, northward, wind(180, 6)))
                .as("from the south, at its back")
                .isLessThan(calm);
    }

    private static Wind wind(double fromDegrees, double metersPerSecond) {
        return new Wind(fromDegrees, metersPerSecond, VirtualFixtures.NOW);
    }

    private static double minutes(Drone drone, double windFromNorth) {
        return minutes(
                drone, VirtualTour.of(VirtualFixtures.mission(1)), windFromNorth == 0 ? null : wind(0, windFromNorth));
    }

    private static double minutes(Drone drone, VirtualTour tour, @Nullable Wind wind) {
        DroneState state = drone.state();
        Geodetic stand =
                Objects.requireNonNull(Objects.requireNonNull(state.position()).point());
        return TourEnergyEstimate.of(tour, 0, state, stand, wind).minutes();
    }

    @Test
    void believesTheNewestWindThatWasFeltNearby() {
        DroneState flies = new Drone("flies", 500).state();
        Instant now = VirtualFixtures.NOW.plusSeconds(600);
        assertThat(Wind.near(VirtualFixtures.FIRST, List.of(flies), now)).isEmpty();
        Wind older = new Wind(90, 3, VirtualFixtures.NOW);
        Wind newer = new Wind(180, 5, VirtualFixtures.NOW.plusSeconds(60));
        List<DroneState> both = List.of(VirtualFixtures.feels(flies, newer), VirtualFixtures.feels(flies, older));
        assertThat(Wind.near(VirtualFixtures.FIRST, both, now)).contains(newer);
        assertThat(Wind.near(VirtualFixtures.FIRST, both, now.plusSeconds(1_200)))
                .as("long ago")
                .isEmpty();
        assertThat(Wind.near(new Geodetic(48.4, 8.5), both, now)).as("far away").isEmpty();
    }

    @Test
    void takesTheBetterLinkOfTwoThatAreAlikeOtherwise() {
        Drone deaf = new Drone("a-deaf", 230);
        deaf.loss = 0.09;
        Drone good = new Drone("b-good", 230);
        good.loss = 0.02;

        DroneChoice choice = choose(DroneRequirements.NONE, deaf, good).orElseThrow();

        assertThat(choice.sentence(id -> "“" + id + "”"))
                .startsWith("“b-good” was chosen: 2 % of its messages lost, the runner-up “a-deaf” 9 % of its messages"
                        + " lost.");
    }

    @Test
    void changesForAHundredRandomFleetsWhenTheDecidingQuantityGoesPastTheRunnerUps() {
        Random random = new Random(20_260_504);
        List<SelectionCriterion> met = new ArrayList<>();
        for (int round = 0; round < 100; round++) {
            List<Drone> fleet = fleet(random, round);

            DroneChoice choice = choose(DroneRequirements.NONE, fleet).orElseThrow();
            SelectionCriterion deciding = choice.deciding();
            assertThat(deciding).as("round %d", round).isNotNull();
            met.add(deciding);
            String sentence = choice.sentence(id -> "[" + id + "]");
            assertThat(sentence)
                    .contains("[" + choice.chosen() + "] was chosen: " + deciding.words(choice.chosenValue()))
                    .contains("the runner-up [" + choice.runnerUp() + "] " + deciding.words(choice.otherValue()));

            List<Drone> nearly = copy(fleet);
            worsen(nearly, choice, deciding, -1);
            assertThat(choose(DroneRequirements.NONE, nearly).orElseThrow().chosen())
                    .as("round %d, not past it yet: %s", round, sentence)
                    .isEqualTo(choice.chosen());
            worsen(fleet, choice, deciding, 1);
            DroneChoice after = choose(DroneRequirements.NONE, fleet).orElseThrow();
            assertThat(after.chosen()).as("round %d: %s", round, sentence).isEqualTo(choice.runnerUp());
            assertThat(after.unfit()).as("round %d: for no other reason", round).isEmpty();
        }
        assertThat(met)
                .contains(SelectionCriterion.DISTANCE, SelectionCriterion.BATTERY_LEFT, SelectionCriterion.LINK_LOSS);
    }

    /** Often alike in what counts first, so that each quantity decides now and then. */
    private static List<Drone> fleet(Random random, int round) {
        List<Drone> fleet = new ArrayList<>();
        int count = 2 + random.nextInt(5);
        for (int i = 0; i < count; i++) {
            Drone drone = new Drone("d" + i, round % 3 == 0 ? 20 + random.nextInt(900) : 230);
            drone.percent = round % 3 == 1 ? 70 + random.nextInt(30) : 90;
            // No two alike: the order of ids is nothing that can be changed.
            drone.loss = (i + 1 + random.nextInt(2) * 7) / 100.0;
            fleet.add(drone);
        }
        return fleet;
    }

    private static List<Drone> copy(List<Drone> fleet) {
        return fleet.stream()
                .map(drone -> {
                    Drone copy = new Drone(drone.id.value(), drone.metersAway);
                    copy.percent = drone.percent;
                    copy.loss = drone.loss;
                    return copy;
                })
                .toList();
    }

    /** That quantity alone, by so many of its steps past the runner-up's; nothing is better than that. */
    private static void worsen(List<Drone> fleet, DroneChoice choice, SelectionCriterion deciding, int steps) {
        Drone chosen = fleet.stream()
                .filter(drone -> drone.id.equals(choice.chosen()))
                .findFirst()
                .orElseThrow();
        switch (deciding) {
            // in the middle of a step of 50 m
            case DISTANCE -> chosen.metersAway = choice.otherValue() + 25 + 50 * steps;
            case BATTERY_LEFT -> chosen.percent -= (int) (choice.chosenValue() - choice.otherValue()) + 5 * steps;
            case LINK_LOSS -> chosen.loss = (choice.otherValue() + steps) / 100;
            case ORDER -> throw new AssertionError("the fleet has no two alike");
        }
    }

    @Test
    void saysOfEachDroneThatCannotServeWhatItLacks() {
        Drone lost = new Drone("lost", 100);
        lost.link = LinkState.SUSPECT;
        Drone armed = new Drone("armed", 100);
        armed.armed = true;
        Drone unknown = new Drone("unknown", 100);
        unknown.percent = null;
        Drone empty = new Drone("empty", 100);
        empty.percent = 25;
        Drone bad = new Drone("bad", 100);
        bad.loss = 0.3;
        Drone plane = new Drone("plane", 100);
        plane.kind = VehicleKind.FIXED_WING;
        Drone blind = new Drone("blind", 100);
        blind.can = Set.of(Capability.ARM, Capability.UPLOAD_MISSION, Capability.START_MISSION);
        Drone unready = new Drone("unready", 100);
        unready.ready = false;
        DroneRequirements needs =
                new DroneRequirements(VehicleKind.MULTICOPTER, Set.of(Capability.TAKE_PICTURE), null, null);

        DroneSelection selection = select(needs, lost, armed, unknown, empty, bad, plane, blind, unready);

        assertThat(selection.choice()).isEmpty();
        areToldByCode(selection.unfit());
        assertThat(selection.unfit())
                .extracting(unfit -> unfit.drone() + ": " + unfit.why().sentence())
                .satisfiesExactly(
                        first -> assertThat(first).isEqualTo("lost: There is no good contact with it."),
                        second -> assertThat(second).isEqualTo("armed: It is armed or in the air."),
                        third -> assertThat(third).isEqualTo("unknown: How full its battery is, is not known."),
                        fourth -> assertThat(fourth)
                                .startsWith("empty: Its battery has 25 %; the mission takes some ")
                                .endsWith("20 % are kept in reserve."),
                        fifth -> assertThat(fifth).isEqualTo("bad: Its link loses 30 % of its messages."),
                        sixth -> assertThat(sixth).isEqualTo("plane: It is a fixed wing, not a multicopter."),
                        seventh -> assertThat(seventh).isEqualTo("blind: It cannot take a picture."),
                        eighth -> assertThat(eighth).isEqualTo("unready: Its own checks do not let it arm."));
    }

    private static void areToldByCode(List<DroneSelection.Unfit> unfit) {
        assertThat(unfit)
                .extracting(one -> one.why().code())
                .containsExactly(
                        "contact-not-good",
                        "drone-not-at-rest",
                        "battery-unknown",
                        "battery-too-low",
                        "link-too-lossy",
                        "kind-not-wanted",
                        "capability-missing",
                        "drone-not-ready-to-arm");
    }

    @Test
    void keepsToTheAreaAndTheEnduranceThatAreNeeded() {
        DroneRequirements near =
                new DroneRequirements(null, Set.of(), null, new RequiredArea(VirtualFixtures.FIRST, 300));
        assertThat(choose(near, new Drone("in", 290), new Drone("out", 310))
                        .orElseThrow()
                        .unfit())
                .singleElement()
                .satisfies(unfit -> assertThat(unfit.why()).startsWith("It does not stand within 300 m of "));

        DroneRequirements lasting = new DroneRequirements(null, Set.of(), 18, null);
        Drone full = new Drone("full", 600);
        full.percent = 95;
        Drone used = new Drone("used", 10);
        used.percent = 85;
        assertThat(choose(lasting, full, used).orElseThrow().chosen()).isEqualTo(full.id);
    }

    @Test
    void listensToWhatElseSpeaksAgainstADrone() {
        DroneSelection selection = DroneSelection.of(
                new ServiceDemand(DroneRequirements.NONE, VirtualTour.of(VirtualFixtures.mission(3)), 0),
                List.of(new Drone("a", 10).state(), new Drone("b", 900).state()),
                (drone, share) -> drone.id().value().equals("a") ? Optional.of(AGAINST) : Optional.empty());

        assertThat(selection.choice().orElseThrow().chosen().value()).isEqualTo("b");
        assertThat(selection.unfit()).containsExactly(new DroneSelection.Unfit(new Drone("a", 0).id, AGAINST));
    }

    @Test
    void asksOnlyForTheBatteryThatTheRestOfAMissionTakes() {
        Drone low = new Drone("low", 10);
        low.percent = 45;
        VirtualTour tour = VirtualTour.of(VirtualFixtures.mission(30));

        assertThat(DroneSelection.of(new ServiceDemand(DroneRequirements.NONE, tour, 0), List.of(low.state()), NONE)
                        .choice())
                .isEmpty();
        low.metersAway = -2_900;
        assertThat(DroneSelection.of(new ServiceDemand(DroneRequirements.NONE, tour, 29), List.of(low.state()), NONE)
                        .choice())
                .isPresent();
    }

    private static Optional<DroneChoice> choose(DroneRequirements needs, Drone... drones) {
        return choose(needs, List.of(drones));
    }

    private static Optional<DroneChoice> choose(DroneRequirements needs, List<Drone> drones) {
        return select(needs, drones.toArray(new Drone[0])).choice();
    }

    private static DroneSelection select(DroneRequirements needs, Drone... drones) {
        List<DroneState> states = List.of(drones).stream().map(Drone::state).toList();
        return DroneSelection.of(new ServiceDemand(needs, VirtualTour.of(VirtualFixtures.mission(3)), 0), states, NONE);
    }
}
