/** Telemetry in a MongoDB that somebody runs: time-series collections that expire by themselves. */
@NullMarked
package org.dronemap.store.mongo;

import org.jspecify.annotations.NullMarked;
