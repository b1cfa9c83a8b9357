package org.dronemap.proxy.roslink.wire;

/**
 * A ROSLink header value (key or owner) that some bridges send as a string and others as a number. Two are the same
 * word when their texts are.
 *
 * @param number it came as a number: bridges compare strictly, so it goes back as one
 */
public record StringOrNumber(String text, boolean number) {}
