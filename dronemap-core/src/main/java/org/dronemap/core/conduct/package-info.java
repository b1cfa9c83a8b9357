/**
 * What the cloud does with drones over time, for users: takes control, writes each step down, commands, goes on after
 * a restart.
 *
 * <p>Enters: what holds for every operation.
 *
 * <p>Never: what a single kind decides.
 */
@NullMarked
package org.dronemap.core.conduct;

import org.jspecify.annotations.NullMarked;
