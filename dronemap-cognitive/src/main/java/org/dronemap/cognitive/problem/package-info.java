/**
 * Planning problems: immutable, never a live drone.
 *
 * <p>Enters: a fact or a bound that a planner must know.
 *
 * <p>Never: live drones.
 */
@NullMarked
package org.dronemap.cognitive.problem;

import org.jspecify.annotations.NullMarked;
