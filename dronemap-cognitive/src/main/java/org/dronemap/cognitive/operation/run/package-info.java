/**
 * A mission run: drones fly a plan together, and the plan changes when something happens to them.
 *
 * <p>Enters: an input, a decision or a stage of runs.
 *
 * <p>Never: threads, clocks and stores.
 */
@NullMarked
package org.dronemap.cognitive.operation.run;

import org.jspecify.annotations.NullMarked;
