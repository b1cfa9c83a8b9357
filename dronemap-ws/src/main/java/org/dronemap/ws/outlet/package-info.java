/**
 * The way in for ground stations of other makers, as users manage it.
 *
 * <p>Enters: use cases about this way in.
 *
 * <p>Never: its wire: that is proxy.outlet.
 */
@NullMarked
package org.dronemap.ws.outlet;

import org.jspecify.annotations.NullMarked;
