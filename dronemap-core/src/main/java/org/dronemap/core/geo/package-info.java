/**
 * Positions and distances on WGS-84.
 *
 * <p>Enters: geometry on the ellipsoid or in a plane.
 *
 * <p>Never: drones.
 */
@NullMarked
package org.dronemap.core.geo;

import org.jspecify.annotations.NullMarked;
