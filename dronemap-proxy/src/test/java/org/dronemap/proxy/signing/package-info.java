/** Tests of keys at work, with real frames and time of their own. */
package org.dronemap.proxy.signing;
