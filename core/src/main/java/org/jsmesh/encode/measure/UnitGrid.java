package org.jsmesh.encode.measure;

/**
 * The places at which an archive can show vertices: the middles of units of 2<sup>shift</sup> cells.
 *
 * @param cellSize length of a cell's side
 * @param offset x, y, z of where cell 0 begins
 * @param shift of the units, at least 1
 * @param later cells by which the vertices of the original will have moved after the next sweep, three for each; null
 *     where they come back to their own positions
 */
public record UnitGrid(double cellSize, double[] offset, int shift, int[] later) {
    /** Length of a unit's side. */
    double unitSize() {
        return cellSize * (1 << shift);
    }

    /** The cell that holds a coordinate. Beside the edge of a cell it may be the one before or after. */
    int cell(double coordinate, int axis) {
        return (int) Math.floor((coordinate - offset[axis]) / cellSize);
    }

    /** The cell in the middle of a unit. */
    int middleCell(int unit) {
        return (unit << shift) + (1 << shift - 1);
    }

    /** Where a vertex in a unit is shown. */
    double middle(int unit, int axis) {
        return offset[axis] + cellSize * middleCell(unit);
    }

    /** The unit that will hold a vertex of the original after the next sweep, by the cell that it has there. */
    int nextUnit(int cell, int vertex, int axis) {
        return cell + (later == null ? 0 : later[3 * vertex + axis]) >> shift;
    }
}
