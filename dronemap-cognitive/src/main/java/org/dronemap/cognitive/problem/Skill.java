package org.dronemap.cognitive.problem;

import org.dronemap.core.drone.Capability;
import org.dronemap.core.stored.Stored;

/**
 * A skill that a task needs and that some drones have.
 *
 * @param words completes the sentence "no drone can …": "take a picture"
 */
@Stored(names = "words")
public record Skill(String words) {
    public Skill {
        if (words.isBlank()) {
            throw new IllegalArgumentException("a skill must have words");
        }
    }

    public static Skill of(Capability capability) {
        return new Skill(capability.phrase());
    }
}
