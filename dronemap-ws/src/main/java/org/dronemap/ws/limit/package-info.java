/**
 * What keeps hostile and slow clients from harming the web server.
 *
 * <p>Enters: a bound that holds before anybody is known.
 *
 * <p>Never: what users may do: that is budget.
 */
@NullMarked
package org.dronemap.ws.limit;

import org.jspecify.annotations.NullMarked;
