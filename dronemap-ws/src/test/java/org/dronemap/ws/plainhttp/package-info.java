/** Tests of the page for phones. */
@org.jspecify.annotations.NullMarked
package org.dronemap.ws.plainhttp;
