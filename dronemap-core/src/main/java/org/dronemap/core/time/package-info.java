/** Time and threads: one source of both for a whole server, real or stepped. */
@NullMarked
package org.dronemap.core.time;

import org.jspecify.annotations.NullMarked;
