/**
 * The server behind its faces: stores, cloud, links and conduct, built and running.
 *
 * <p>Enters: what is built once, across modules.
 *
 * <p>Never: faces.
 */
@NullMarked
package org.dronemap.ws.server;

import org.jspecify.annotations.NullMarked;
