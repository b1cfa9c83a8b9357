/**
 * What is remembered of drones: their states over time, what happened, and each flight; read long after, kept by
 * rules.
 *
 * <p>Enters: what is kept of states, and for how long.
 *
 * <p>Never: the database.
 */
@NullMarked
package org.dronemap.core.history;

import org.jspecify.annotations.NullMarked;
