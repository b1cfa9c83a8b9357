/**
 * The description of the stream by AsyncAPI.
 *
 * <p>Enters: what says more of topics and requests.
 *
 * <p>Never: a client.
 */
@NullMarked
package org.dronemap.ws.stream.description;

import org.jspecify.annotations.NullMarked;
