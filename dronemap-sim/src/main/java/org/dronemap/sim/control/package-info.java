/**
 * Faults on order: a line protocol on a loopback port.
 *
 * <p>Enters: an order to fail.
 *
 * <p>Never: how a vehicle flies.
 */
@NullMarked
package org.dronemap.sim.control;

import org.jspecify.annotations.NullMarked;
