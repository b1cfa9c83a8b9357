package org.dronemap.cognitive.follow;

import java.time.Instant;
import org.dronemap.core.geo.Geodetic;
import org.dronemap.sim.physics.Position;

/** A copter in the air that is told where to be, on a clock that the trial turns. */
interface Copter {
    void live(double seconds);

    /** What a cloud says to an ArduCopter that it leads. */
    void hear(Aim aim);

    /** The same without how the place moves. */
    void hearPlace(Aim aim);

    /** Metres north and east of home, really. */
    Position position();

    /** What it says of itself. */
    Whereabouts whereabouts(Instant at);

    /** Where a place so many metres east and north of home is. */
    Geodetic place(double east, double north);
}
