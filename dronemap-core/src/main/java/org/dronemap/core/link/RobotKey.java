package org.dronemap.core.link;

import java.time.Instant;
import org.dronemap.core.drone.DroneId;
import org.jspecify.annotations.Nullable;

/**
 * Key by which a robot authenticates each ROSLink message; binds the robot to one drone. Who shows it is that drone,
 * from the first time on.
 *
 * @param drone the drone that it makes of its robot, which may never have called in yet
 * @param label what people call it
 * @param systemId the only one that the robot may have, 0 to 65535
 * @param owner whom the robot has to name where it names an owner; null: anybody
 * @param hash of the key, which is not kept itself
 * @param madeBy the name that its maker had then
 * @param account of its maker
 */
public record RobotKey(
        DroneId drone,
        String label,
        int systemId,
        @Nullable String owner,
        String hash,
        String madeBy,
        String account,
        Instant madeAt) {
    @Override
    public String toString() {
        return "RobotKey[" + drone + ", " + label + "]";
    }
}
