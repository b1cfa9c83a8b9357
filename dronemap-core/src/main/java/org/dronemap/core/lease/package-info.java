/**
 * Who commands a drone: one lease for each, held by one user at a time or by the pilot at the vehicle.
 *
 * <p>Enters: a rule of who has a drone.
 *
 * <p>Never: commands.
 */
@NullMarked
package org.dronemap.core.lease;

import org.jspecify.annotations.NullMarked;
