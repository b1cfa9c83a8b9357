package org.dronemap.proxy.roslink;

import java.util.Optional;
import org.dronemap.core.link.RobotKey;

/** Looks up the access keys that were issued to ROSLink robots. Any thread; answers at once. */
public interface RobotKeys {
    /** Whose key that is; empty for one that nobody issued, or that is void. */
    Optional<RobotKey> find(String key);

    /** It can only have been issued, whether it is valid or not; anything else is a word of a robot's own. */
    boolean isOfIssuedForm(String key);

    /** It has been neither replaced nor revoked. */
    boolean isValid(RobotKey key);
}
