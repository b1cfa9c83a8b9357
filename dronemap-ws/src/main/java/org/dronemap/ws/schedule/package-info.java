/**
 * Tasks at fixed intervals.
 *
 * <p>Enters: what runs tasks of any room.
 *
 * <p>Never: a task.
 */
@NullMarked
package org.dronemap.ws.schedule;

import org.jspecify.annotations.NullMarked;
