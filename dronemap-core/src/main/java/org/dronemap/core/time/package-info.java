/**
 * Time and threads: one source of both for a whole server, real or stepped.
 *
 * <p>Enters: a way of waiting or running that both times have.
 *
 * <p>Never: any other source of time.
 */
@NullMarked
package org.dronemap.core.time;

import org.jspecify.annotations.NullMarked;
