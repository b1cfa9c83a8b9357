/**
 * Bringing several flying drones home, or down, as one operation: who comes at which height and after whom, and a state
 * machine that carries it out.
 *
 * <p>Enters: what plans or conducts that drones come home or down together.
 *
 * <p>Never: threads, clocks and stores.
 */
@NullMarked
package org.dronemap.cognitive.operation.recovery;

import org.jspecify.annotations.NullMarked;
