package org.dronemap.proxy.roslink;

import java.util.Optional;
import org.jspecify.annotations.Nullable;

/** The keys that were issued to robots. Any thread; answers at once. */
@FunctionalInterface
public interface RobotKeys {
    /** Whose key that is; empty for one that nobody issued. */
    Optional<Issued> find(String key);

    /** Issued nothing. */
    static RobotKeys none() {
        return key -> Optional.empty();
    }

    /**
     * Whose a key is.
     *
     * @param identity names the key, and is no secret
     * @param systemId the only one that the robot may have
     * @param owner whom the robot has to name where it names an owner; null: anybody
     */
    record Issued(String identity, int systemId, @Nullable String owner) {}
}
