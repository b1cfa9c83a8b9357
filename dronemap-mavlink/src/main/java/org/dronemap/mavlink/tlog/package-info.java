/**
 * Recordings of links: a time in microseconds before each raw frame.
 *
 * <p>Enters: what reads or writes such files.
 *
 * <p>Never: sockets.
 */
@NullMarked
package org.dronemap.mavlink.tlog;

import org.jspecify.annotations.NullMarked;
