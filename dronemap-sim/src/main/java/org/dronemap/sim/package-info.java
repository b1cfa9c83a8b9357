/**
 * Simulated vehicles: a stand-in for ArduPilot and PX4 that speaks real MAVLink.
 *
 * <p>Enters: what starts simulated vehicles.
 *
 * <p>Never: the product.
 */
@NullMarked
package org.dronemap.sim;

import org.jspecify.annotations.NullMarked;
