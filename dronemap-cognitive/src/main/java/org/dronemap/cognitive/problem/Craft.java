package org.dronemap.cognitive.problem;

import java.util.Set;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.stored.Stored;

/**
 * A drone of a planning problem: its start, end, performance, energy and skills.
 *
 * @param homeAmslMeters what altitudes above its home are counted from
 * @param linkQuality 0 (nothing arrives) to 1 (everything does)
 */
@Stored(names = "id start finish performance supply skills homeAmslMeters linkQuality")
public record Craft(
        DroneId id,
        Start start,
        Finish finish,
        Performance performance,
        EnergyBudget supply,
        Set<Skill> skills,
        double homeAmslMeters,
        double linkQuality) {
    public Craft {
        skills = Set.copyOf(skills);
        Require.within("homeAmslMeters", homeAmslMeters, -500, 10_000);
        Require.within("linkQuality", linkQuality, 0, 1);
    }

    /** Stands at home, returns there, and nothing is known of its battery. */
    public static Craft atHome(DroneId id, Place home, Performance performance) {
        return new Craft(
                id,
                Start.onGround(home),
                Finish.landing(home),
                performance,
                EnergyBudget.UNLIMITED,
                Set.of(),
                home.altitudeAmslMeters(),
                1);
    }

    public Craft with(EnergyBudget other) {
        return new Craft(id, start, finish, performance, other, skills, homeAmslMeters, linkQuality);
    }

    public Craft with(Start other) {
        return new Craft(id, other, finish, performance, supply, skills, homeAmslMeters, linkQuality);
    }

    public Craft with(Finish other) {
        return new Craft(id, start, other, performance, supply, skills, homeAmslMeters, linkQuality);
    }

    public Craft with(Performance other) {
        return new Craft(id, start, finish, other, supply, skills, homeAmslMeters, linkQuality);
    }

    public Craft withSkills(Set<Skill> other) {
        return new Craft(id, start, finish, performance, supply, other, homeAmslMeters, linkQuality);
    }

    public Craft withLinkQuality(double other) {
        return new Craft(id, start, finish, performance, supply, skills, homeAmslMeters, other);
    }

    /** Whether its first way begins with a take-off. */
    public boolean beginsWithTakeOff() {
        return !start.airborne() && performance.response() != WindResponse.UNTOUCHED;
    }

    /** Whether its last way ends with a landing. */
    public boolean lands() {
        return finish.landed() && performance.response() != WindResponse.UNTOUCHED;
    }

    public boolean can(Task task) {
        return skills.containsAll(task.needs());
    }
}
