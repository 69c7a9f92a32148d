// Example 1 of the lecture, as printed there.
// clang-format off
#include "linearSolver.h"
class A1 : public implicitMatrix {
    public:
         virtual void matVecMult(double x[], double b[]) {
             b[0] = 2 * x[0];
             b[1] = 1 * x[1];
         }
};
int main(int argc, char **argv) {
    double x[2] = {0.0, 0.0};
    double b[2] = {1.0, 1.0};
    int steps = 100;
    implicitMatrix *a1 = new A1();
    double err = ConjGrad(2, a1, x, b, 1.0e-5, &steps);
    delete a1;
    printf("Solved in %i steps with error %f.\n", steps, err);
    printf("A1 * [%f %f]^T = [%f %f]^T.\n", x[0], x[1], b[0], b[1]);
    return 0;
}
