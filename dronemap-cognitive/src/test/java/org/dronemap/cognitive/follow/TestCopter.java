package org.dronemap.cognitive.follow;

import java.time.Instant;
import org.dronemap.core.geo.Geodetic;
import org.dronemap.core.separation.DroneFix;
import org.dronemap.sim.physics.NeuPosition;

/** A copter in the air that is told where to be, on a clock that the trial turns. */
interface TestCopter {
    void live(double seconds);

    /** What a cloud says to an ArduCopter that it leads. */
    void hear(GuidanceSetpoint aim);

    /** The same without how the place moves. */
    void hearPlace(GuidanceSetpoint aim);

    /** Metres north and east of home, really. */
    NeuPosition position();

    /** What it says of itself. */
    DroneFix whereabouts(Instant at);

    /** Where a place so many metres east and north of home is. */
    Geodetic place(double east, double north);
}
