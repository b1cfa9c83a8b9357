/**
 * Rules of the gate and of drones on their lanes, as functions of what is known.
 *
 * <p>Enters: a rule that asks nobody and sends nothing.
 *
 * <p>Never: threads, and commands that are sent.
 */
@NullMarked
package org.dronemap.core.cloud.rule;

import org.jspecify.annotations.NullMarked;
