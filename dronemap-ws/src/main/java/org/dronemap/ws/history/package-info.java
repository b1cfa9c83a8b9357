/**
 * What is remembered of drones: flights, telemetry and events.
 *
 * <p>Enters: use cases that look back.
 *
 * <p>Never: what is happening now.
 */
@NullMarked
package org.dronemap.ws.history;

import org.jspecify.annotations.NullMarked;
