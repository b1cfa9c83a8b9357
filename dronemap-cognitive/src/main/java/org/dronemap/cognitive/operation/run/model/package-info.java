/**
 * State of a run: its drones, waypoints, settings and causes, as it is stored.
 *
 * <p>Enters: a fact about a run.
 *
 * <p>Never: what follows from it.
 */
@NullMarked
package org.dronemap.cognitive.operation.run.model;

import org.jspecify.annotations.NullMarked;
