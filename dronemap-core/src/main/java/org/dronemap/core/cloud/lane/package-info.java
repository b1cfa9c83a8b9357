/**
 * Lanes: the threads that own drones, the thread that writes to the store, and who watches that they go on.
 *
 * <p>Enters: what owns or watches a thread.
 *
 * <p>Never: decisions about drones.
 */
@NullMarked
package org.dronemap.core.cloud.lane;

import org.jspecify.annotations.NullMarked;
