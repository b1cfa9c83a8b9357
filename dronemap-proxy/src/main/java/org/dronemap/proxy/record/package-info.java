/** Recordings in: a tlog played through the same sessions as a live link, with nothing sent. */
@NullMarked
package org.dronemap.proxy.record;

import org.jspecify.annotations.NullMarked;
