/**
 * What is due to one client of the stream, in which order and how much at a time.
 *
 * <p>Enters: what bounds and orders messages.
 *
 * <p>Never: what messages say.
 */
@NullMarked
package org.dronemap.ws.stream.delivery;

import org.jspecify.annotations.NullMarked;
