/**
 * Forms of text that a track is taken along in: CSV, GeoJSON, KML, GPX.
 *
 * <p>Enters: a new form.
 *
 * <p>Never: where the points come from.
 */
@NullMarked
package org.dronemap.ws.track;

import org.jspecify.annotations.NullMarked;
