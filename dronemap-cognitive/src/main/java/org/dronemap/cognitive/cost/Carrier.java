package org.dronemap.cognitive.cost;

/**
 * One drone as the search sees it.
 *
 * @param type which legs it flies ({@link Legs})
 * @param readySeconds when it can set off, on the plan's clock
 * @param rangeJoules what it may draw till its end, the reserve left out; infinite without a limit
 */
public record Carrier(int type, double readySeconds, double rangeJoules) {}
