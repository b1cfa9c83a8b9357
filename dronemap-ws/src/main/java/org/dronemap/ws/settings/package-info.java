/**
 * Settings of the server, checked when it starts.
 *
 * <p>Enters: a setting: see the guide.
 *
 * <p>Never: what it is used for.
 */
@NullMarked
package org.dronemap.ws.settings;

import org.jspecify.annotations.NullMarked;
