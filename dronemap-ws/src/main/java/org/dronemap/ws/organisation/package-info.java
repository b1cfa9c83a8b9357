/**
 * Organisations, groups, grants and gifts of drones.
 *
 * <p>Enters: use cases about who sees and commands whose drones.
 *
 * <p>Never: commands themselves.
 */
@NullMarked
package org.dronemap.ws.organisation;

import org.jspecify.annotations.NullMarked;
