package org.dronemap.cognitive.problem;

import org.dronemap.core.stored.Stored;

/**
 * The power that a vehicle is planned to draw hovering, cruising and climbing, in W. An aeroplane hovers by circling.
 *
 * @param cruise at its cruising speed through still air
 * @param climb straight up at its climbing speed
 */
@Stored(names = "hover cruise climb")
public record Power(double hover, double cruise, double climb) {
    private static final double MOST = 1_000_000;

    public Power {
        Require.within("hover power", hover, 0, MOST);
        Require.within("cruise power", cruise, 0, MOST);
        Require.within("climb power", climb, 0, MOST);
    }
}
