/** Recordings of links: a time in microseconds before each raw frame. */
@NullMarked
package org.dronemap.mavlink.tlog;

import org.jspecify.annotations.NullMarked;
