/**
 * Telemetry in a MongoDB that somebody runs: time-series collections that expire by themselves.
 *
 * <p>Enters: telemetry in MongoDB.
 *
 * <p>Never: anything that must not be lost.
 */
@NullMarked
package org.dronemap.store.mongo;

import org.jspecify.annotations.NullMarked;
