package org.dronemap.cognitive.allocate;

/** A set of the integers 0 to n-1 that is quick to change and to iterate, in the order of changes. */
final class IndexSet {
    private final int[] items;
    private final int[] places;
    private int size;

    IndexSet(int capacity) {
        items = new int[capacity];
        places = new int[capacity];
        for (int i = 0; i < capacity; i++) {
            items[i] = i;
            places[i] = i;
        }
    }

    int size() {
        return size;
    }

    int get(int index) {
        return items[index];
    }

    boolean has(int item) {
        return places[item] < size;
    }

    void clear() {
        size = 0;
    }

    void fill() {
        size = items.length;
    }

    void add(int item) {
        if (places[item] >= size) {
            swap(places[item], size++);
        }
    }

    void remove(int item) {
        if (places[item] < size) {
            swap(places[item], --size);
        }
    }

    private void swap(int one, int other) {
        int item = items[one];
        items[one] = items[other];
        items[other] = item;
        places[items[one]] = one;
        places[item] = other;
    }
}
